// Meshes that users bring to be worn.
#pragma once

#include "model/project/head_part.h"
#include "sim/skin/head_mesh.h"

#include <QByteArray>
#include <QString>

#include <cstddef>
#include <memory>
#include <vector>

namespace hairpaint::model {

inline constexpr std::size_t kMostOwnVertices = 200'000; ///< Of all surfaces together, as are the next two.
inline constexpr std::size_t kMostOwnTriangles = 200'000;
inline constexpr std::size_t kMostOwnPixels = std::size_t{1} << 22U;
inline constexpr int kMostOwnMeshes = 4096; ///< Limit on the number of an own mesh in a file.

/// What has one material.
struct OwnSurface
{
    HeadPart part;                                 ///< Its colour is multiplied by that of what is worn.
    std::shared_ptr<const sim::HeadMesh> mirrored; ///< The part's mesh with x the other way round.
};

/// Fills the box of -1..1 on each axis that has any extent, x to the left ear, y up, z to the front. Immutable once
/// shared between threads.
struct OwnMesh
{
    QString name;                     ///< Base name of the file that it came in.
    int entry = 0;                    ///< Its number in the file that it is read from.
    QByteArray glb;                   ///< As files hold it (hairpaint_format.md); empty until it is read.
    std::vector<OwnSurface> surfaces; ///< At least one; none until it is read.
};

/// Equal where the bytes are.
struct SharedOwnMesh
{
    std::shared_ptr<const OwnMesh> own;
    [[nodiscard]] bool isRead() const { return own != nullptr && !own->surfaces.empty(); }
    friend bool operator==(const SharedOwnMesh& a, const SharedOwnMesh& b)
    {
        return a.own == b.own || (a.own != nullptr && b.own != nullptr && a.own->name == b.own->name &&
                                  a.own->entry == b.own->entry && a.own->glb == b.own->glb);
    }
};

} // namespace hairpaint::model
