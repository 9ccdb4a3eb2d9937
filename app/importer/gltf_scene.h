// The meshes, nodes and skins of a glTF.
#pragma once

#include "app/importer/foreign_scene.h"
#include "app/importer/gltf_data.h"

namespace hairpaint::importer {

/// The scene that the file shows first, in metres, y up, face toward z, as it is at rest. uvs are those that the base
/// colour's texture uses (KHR_texture_transform too), the first where there is none. Refuses what asks for an extension
/// that would change the mesh and is not known here.
[[nodiscard]] tl::expected<ForeignScene, wire::Refusal> gltfScene(const GltfFile& file, const BufferReader& reader);

/// The same of a file, whose buffers lie in its folder. `path`: UTF-8.
[[nodiscard]] tl::expected<ForeignScene, wire::Refusal> readGltf(const std::string& path);

} // namespace hairpaint::importer
