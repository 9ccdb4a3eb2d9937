// Writes a mesh as the project's own subset of binary glTF 2.0.
//
// One mesh, one primitive of triangles; UNSIGNED_INT indices, POSITION with bounds (m), NORMAL, TEXCOORD_0 with v down
// as glTF wants it and _UV with v up. Little endian. Source: Khronos, glTF 2.0 specification (2021), section 4.
#pragma once

#include <filesystem>

#include "sim/skin/head_mesh.h"

namespace hairpaint::heads {

// False if the file could not be written.
[[nodiscard]] bool writeGlb(const sim::HeadMesh& mesh, const std::filesystem::path& path);

} // namespace hairpaint::heads
