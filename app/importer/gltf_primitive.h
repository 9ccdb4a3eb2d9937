// One primitive of a glTF's mesh.
#pragma once

#include "app/importer/foreign_scene.h"
#include "app/importer/gltf_data.h"

namespace hairpaint::importer {

/// Which joint each index of a vertex stands for.
struct GltfSkin
{
    std::vector<SceneBone> bones;    ///< Each node once.
    std::vector<std::int32_t> slots; ///< The skin's list: a bone, or -1 where there is no such node.
};

/// `skin`: null where the mesh has none. `morphs`: of the mesh's targets, at rest. A primitive without a surface has no
/// triangles.
[[nodiscard]] tl::expected<SceneMesh, wire::Refusal> gltfPrimitive(GltfData& data, const GltfFile& file,
                                                                   const tinygltf::Primitive& primitive,
                                                                   const GltfSkin* skin,
                                                                   const std::vector<double>& morphs);

} // namespace hairpaint::importer
