// A scene as the one mesh that a head is.
#pragma once

#include "app/importer/foreign_scene.h"
#include "model/files/wire_format.h"

#include <tl/expected.hpp>

namespace hairpaint::importer {

/// All meshes of the scene that have triangles and uvs as one, nodes' transforms applied; others are left out. uvs are
/// moved into 0..1 a triangle at a time; identical vertices are joined. Where meshes are skinned, with the scene's
/// joints.
[[nodiscard]] tl::expected<model::RiggedMesh, wire::Refusal> flattened(const ForeignScene& scene);

} // namespace hairpaint::importer
