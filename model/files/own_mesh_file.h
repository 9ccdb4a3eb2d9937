// Meshes that users bring to be worn: made from what the helper decodes, and in archives, as worn/<number>.glb.
// Any thread. Errors: clauses for a sentence of sentences.h.
#pragma once

#include "model/files/archive.h"
#include "model/heads/rigged_mesh.h"
#include "model/project/worn.h"

#include <functional>
#include <memory>
#include <vector>

namespace hairpaint::model {

inline constexpr qint64 kMostOwnMeshBytes = qint64{32} << 20;

/// A mesh as a program brings it, ready to be put on.
struct BroughtMesh
{
    std::shared_ptr<const OwnMesh> own;
    glm::vec3 semiAxesM{0.0F}; ///< Half its extents; at the kind's usual size where the file's is none that is worn.
    QRgb colour = 0;           ///< Its colour where it has one material without texture, else white.
    bool passable = false;     ///< Whether it is much less than the ellipsoid in it, as glasses are.
};
/// Refuses what is too large or has no surface. Parts of one material become one, without joints; textures are made
/// smaller until they have kMostOwnPixels.
[[nodiscard]] Checked<BroughtMesh> broughtMesh(const RiggedMesh& source, const QString& name);
/// A thing of the kind that has own meshes, on the skin there, without an id.
[[nodiscard]] Worn wornFrom(const BroughtMesh& mesh, const sim::SurfacePoint& point, Id group);

[[nodiscard]] Checked<std::shared_ptr<const OwnMesh>> ownMeshFromGlb(const QString& name, const QByteArray& glb);

/// The bytes of a mesh by its number.
using MeshReader = std::function<Checked<QByteArray>(int number)>;
/// Reads the meshes that project.json names (OwnMesh::entry), each once.
[[nodiscard]] Checked<void> readOwnMeshes(std::vector<Worn>& worn, const MeshReader& read);
[[nodiscard]] Checked<void> readOwnMeshes(std::vector<Worn>& worn, const ArchiveReader& archive);
[[nodiscard]] QString ownMeshEntryName(int number);
void addOwnMeshes(ArchiveWriter& archive, const std::vector<Worn>& worn);

} // namespace hairpaint::model
