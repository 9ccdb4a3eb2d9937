// Foreign meshes: glTF and VRM by tinygltf, other formats by Assimp.
#pragma once

#include "model/files/wire_format.h"

#include <tl/expected.hpp>

#include <string>

namespace hairpaint::importer {

/// `path`: UTF-8. The scene as one mesh: see scene_flattener.h.
[[nodiscard]] tl::expected<model::RiggedMesh, wire::Refusal> readMesh(const std::string& path, bool needsUvs = true);

} // namespace hairpaint::importer
