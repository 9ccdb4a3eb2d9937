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
/// Of a mesh that was read; without joints where it has no skin.
[[nodiscard]] Checked<HeadSkeleton> skeletonFromGlb(const QByteArray& glb);
/// Its meshes after the first, in the source's space, and what the first shows.
struct GlbParts
{
    std::vector<HeadPart> parts;
    std::vector<std::vector<BoneWeights>> weights; ///< By part; none where it has none.
    std::shared_ptr<const sim::MeshTexture> texture;
};
[[nodiscard]] Checked<GlbParts> partsFromGlb(const QByteArray& glb);
/// How its first mesh's layouts lie side by side; one tile where it tells nothing of that, or nothing that can be.
[[nodiscard]] UvTiles tilesFromGlb(const QByteArray& glb);

} // namespace hairpaint::model
