// Meshes that users bring to be worn.
#pragma once

#include "sim/skin/head_mesh.h"

#include <QByteArray>
#include <QString>

#include <cstddef>
#include <memory>

namespace hairpaint::model {

inline constexpr std::size_t kMostOwnVertices = 200'000;
inline constexpr std::size_t kMostOwnTriangles = 200'000;
inline constexpr int kMostOwnMeshes = 4096; ///< Limit on the number of an own mesh in a file.

/// Fills the box of -1..1 on each axis that has any extent, x to the left ear, y up, z to the front. Immutable once
/// shared between threads.
struct OwnMesh
{
    QString name;                                  ///< Base name of the file that it came in.
    int entry = 0;                                 ///< Its number in the file that it is read from.
    QByteArray glb;                                ///< As files hold it (hairpaint_format.md); empty until it is read.
    std::shared_ptr<const sim::HeadMesh> mesh;     ///< Null until it is read.
    std::shared_ptr<const sim::HeadMesh> mirrored; ///< The same with x the other way round.
};

/// Equal where the bytes are.
struct SharedOwnMesh
{
    std::shared_ptr<const OwnMesh> own;
    [[nodiscard]] bool isRead() const { return own != nullptr && own->mesh != nullptr; }
    friend bool operator==(const SharedOwnMesh& a, const SharedOwnMesh& b)
    {
        return a.own == b.own || (a.own != nullptr && b.own != nullptr && a.own->name == b.own->name &&
                                  a.own->entry == b.own->entry && a.own->glb == b.own->glb);
    }
};

} // namespace hairpaint::model
