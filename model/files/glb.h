// Reading chunks, accessors and buffer views of the subset of binary glTF that heads are kept in: see "head.glb" in
// model/files/hairpaint_format.md.
// Any thread. Errors: clauses for a sentence of sentences.h; every index and size is checked.
#pragma once

#include "model/heads/rigged_mesh.h"
#include "model/project/head_part.h"
#include "model/values/sentences.h"

#include <QByteArray>

#include <memory>
#include <vector>

namespace hairpaint::model {

[[nodiscard]] Checked<sim::HeadMesh> meshFromGlb(const QByteArray& glb);
/// The skeleton and weights of the first mesh; empty where that mesh has no skin.
[[nodiscard]] Checked<HeadSkeleton> skeletonFromGlb(const QByteArray& glb);
/// The meshes after the first, in the source's space, and the material of the first.
struct GlbParts
{
    HeadPart first; ///< Without mesh; white where the file names no material.
    std::vector<HeadPart> parts;
    /// By part: the weights of its vertices; empty where the part has none.
    std::vector<std::vector<BoneWeights>> weights;
};
[[nodiscard]] Checked<GlbParts> partsFromGlb(const QByteArray& glb);
/// The tiles of the first mesh's layout; one tile where the file names none or names invalid ones.
[[nodiscard]] UvTiles tilesFromGlb(const QByteArray& glb);

} // namespace hairpaint::model
