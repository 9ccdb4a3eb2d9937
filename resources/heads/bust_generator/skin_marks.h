// What the skin looks like at each vertex of the bust: sim::SkinMarks.
#pragma once

#include <filesystem>
#include <vector>

#include "sim/skin/head_mesh.h"

namespace hairpaint::heads {

// The sky that each vertex sees is found by rays. Symmetric where the mesh is.
std::vector<sim::SkinMarks> skinMarks(const sim::HeadMesh& mesh);

// Four bytes a vertex. False if the file could not be written.
[[nodiscard]] bool writeMarks(const std::vector<sim::SkinMarks>& marks, const std::filesystem::path& path);

} // namespace hairpaint::heads
