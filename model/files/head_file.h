// Heads: the built-in one, and our exact subset of binary glTF that project files hold.
#pragma once

#include "model/files/sentences.h"
#include "model/project.h"

#include <functional>

namespace hairpaint::model {

/// The frozen built-in head "bust-1" (resources/heads). Loaded once, then shared.
[[nodiscard]] std::shared_ptr<const Head> builtInHead();
[[nodiscard]] std::vector<sim::Ellipsoid> builtInEllipsoids();

/// Applies scale and axis to a source mesh (our subset of glb), centres nothing, and builds the skin. Fails for what is
/// no mesh, and for a head smaller than 1 mm, larger than 100 m or further than 1 km from the origin. Cancelled where
/// `goesOn`, asked every few thousand faces, returns false.
[[nodiscard]] Result<std::shared_ptr<const Head>> makeHead(const QString& name, const QByteArray& sourceGlb,
                                                           float unitScale, UpAxis upAxis,
                                                           const std::function<bool()>& goesOn = {});
/// The same, for a sentence that names the file which holds the head; null where it was cancelled. Throws where memory
/// runs out.
[[nodiscard]] Checked<std::shared_ptr<const Head>> headFromGlb(const QString& name, const QByteArray& sourceGlb,
                                                               float unitScale, UpAxis upAxis,
                                                               const std::function<bool()>& goesOn = {});

/// What scale and axis a mesh of unknown origin most likely has: the one under which it is about a head's size and
/// taller along the axis.
struct HeadGuess
{
    float unitScale = 1.0F;
    UpAxis upAxis = UpAxis::Y;
};
[[nodiscard]] HeadGuess guessHead(const sim::HeadMesh& source);

} // namespace hairpaint::model
