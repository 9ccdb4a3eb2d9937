// Foreign meshes, read by Assimp. The only file that includes it is mesh_import.cpp.
#pragma once

#include "model/files/wire_format.h"

#include <tl/expected.hpp>

namespace hairpaint::importer {

/// `path`: UTF-8. All meshes of the scene that have triangles and uvs as one, nodes' transforms applied; others are
/// left out. uvs are moved into 0..1 a triangle at a time; identical vertices are joined; missing normals are smooth.
[[nodiscard]] tl::expected<sim::HeadMesh, wire::Refusal> readMesh(const std::string& path);

} // namespace hairpaint::importer
