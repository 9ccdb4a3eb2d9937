// Textures of a model, decoded for what shows them.
#pragma once

#include "app/importer/foreign_scene.h"

namespace hairpaint::importer {

/// The images that the mesh's parts name by their numbers become its textures, each once; parts are left without one
/// that can't be decoded. Those that are too large for MeshTexture's limits are halved until they fit.
void decodeTextures(model::RiggedMesh& mesh, const std::vector<std::vector<std::byte>>& images);

} // namespace hairpaint::importer
