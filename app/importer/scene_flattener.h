// A scene as the one mesh that a head is.
#pragma once

#include "app/importer/foreign_scene.h"
#include "model/files/wire_format.h"

#include <tl/expected.hpp>

namespace hairpaint::importer {

/// All meshes of the scene that have triangles as one, part after part, nodes' transforms applied. uvs are
/// moved into 0..1 a triangle at a time, and are 0 where a mesh has none; identical vertices of a part are joined. A
/// part names its texture by the scene's image. Where no mesh has uvs it fails if it `needsUvs`. Where meshes are
/// skinned, with the scene's joints.
[[nodiscard]] tl::expected<model::RiggedMesh, wire::Refusal> flattened(const ForeignScene& scene, bool needsUvs = true);

} // namespace hairpaint::importer
