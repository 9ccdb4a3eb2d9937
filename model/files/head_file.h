// Heads: the built-in one, and our exact subset of binary glTF that project files hold.
#pragma once

#include "model/files/head_guess.h"
#include "model/heads/uv_tiles.h"
#include "model/project/project.h"
#include "model/values/sentences.h"

#include <functional>

namespace hairpaint::model {

/// The built-in head that a new project has (model/heads). Loaded once, then shared.
[[nodiscard]] std::shared_ptr<const Head> defaultHead();
/// The one that a file names.
[[nodiscard]] Checked<std::shared_ptr<const Head>> builtInHead(const QString& name);
/// What hair collides with on the built-in head of that name; on that of a new project, where none has it.
[[nodiscard]] std::vector<sim::Ellipsoid> builtInEllipsoids(const QString& name = {});
struct NamedHead
{
    QString name;
    QString title; ///< Translated.
};
/// The one of a new project first.
[[nodiscard]] std::vector<NamedHead> builtInHeads();

/// Applies scale and axis to a source mesh (our subset of glb), centres nothing, builds the skin, and finds landmarks
/// and scalp by the built-in head. Fails for what is no mesh, and for a head smaller than 1 mm, larger than 100 m or
/// further than 1 km from the origin. Cancelled where `goesOn`, asked every few thousand faces, returns false.
[[nodiscard]] Result<std::shared_ptr<const Head>> makeHead(const QString& name, const QByteArray& sourceGlb,
                                                           float unitScale, UpAxis upAxis,
                                                           const std::function<bool()>& goesOn = {});
/// The same, for a sentence that names the file which holds the head; null where it was cancelled. Throws where memory
/// runs out. Landmarks that are known are not looked for.
[[nodiscard]] Checked<std::shared_ptr<const Head>> headFromGlb(const QString& name, const QByteArray& sourceGlb,
                                                               float unitScale, UpAxis upAxis,
                                                               const std::function<bool()>& goesOn = {},
                                                               const std::optional<sim::HeadLandmarks>& landmarks = {});

/// The same head with its landmarks there, and the scalp that follows from them. Any thread; some 50 ms.
[[nodiscard]] std::shared_ptr<const Head> withLandmarks(const Head& head, const sim::HeadLandmarks& landmarks);

/// The joints of an imported head, Hd; none where it came without.
[[nodiscard]] Checked<HeadSkeleton> skeletonOf(const Head& head);
/// How an imported head's layouts lie side by side on its maps; one tile for every other.
[[nodiscard]] UvTiles tilesOf(const std::shared_ptr<const Head>& head);

} // namespace hairpaint::model
