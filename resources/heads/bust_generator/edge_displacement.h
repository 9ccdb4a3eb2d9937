// How far the middles of a mesh's edges lie from the bust's surface.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "sim/skin/head_mesh.h"

namespace hairpaint::heads {

// In micrometres along sim::middleOf's normal, one for each of sim::edgesOf; at most a third of the edge's length.
// Symmetric to the last digit where the mesh is.
std::vector<std::int16_t> edgeDisplacements(const sim::HeadMesh& mesh);

// Little endian. False if the file could not be written.
[[nodiscard]] bool writeDisplacements(const std::vector<std::int16_t>& displacements,
                                      const std::filesystem::path& path);

} // namespace hairpaint::heads
