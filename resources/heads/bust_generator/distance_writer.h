// The bust's grid of distances as a file.
#pragma once

#include <filesystem>

#include "sim/skin/distance_grid.h"

namespace hairpaint::heads {

// The layout (origin, cell, three sizes: 32 bits each, little endian), the number of bytes that follow unpacked (32
// bits, big endian), then a zlib stream of the values, each less the one before it. False if it could not be written.
[[nodiscard]] bool writeDistances(const sim::DistanceGrid& grid, const std::filesystem::path& path);

} // namespace hairpaint::heads
