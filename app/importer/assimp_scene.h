// Scenes of some forty formats, read by Assimp. What else includes it is plain_files.
#pragma once

#include "app/importer/foreign_scene.h"
#include "model/files/wire_format.h"

#include <tl/expected.hpp>

#include <string>

namespace hairpaint::importer {

/// `path`: UTF-8. Missing normals are smooth. Axis and unit are told where the format has them (FBX, COLLADA).
[[nodiscard]] tl::expected<ForeignScene, wire::Refusal> readByAssimp(const std::string& path);

} // namespace hairpaint::importer
