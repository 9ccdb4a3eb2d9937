// Foreign meshes, read by Assimp. What else includes it are plain_files and scene_skeleton.
#pragma once

#include "model/files/wire_format.h"

#include <tl/expected.hpp>

namespace hairpaint::importer {

/// `path`: UTF-8. All meshes of the scene that have triangles and uvs as one, nodes' transforms applied; others are
/// left out. uvs are moved into 0..1 a triangle at a time; identical vertices are joined; missing normals are smooth.
/// Where meshes are skinned, with the scene's joints.
[[nodiscard]] tl::expected<model::RiggedMesh, wire::Refusal> readMesh(const std::string& path);

} // namespace hairpaint::importer
