// The index of a cell along the Hilbert curve through a cube: cells near on the curve are near in space.
#pragma once

#include <glm/glm.hpp>

#include <cstdint>

namespace hairpaint::sim {

inline constexpr int kHilbertBits = 10; ///< An axis: cells are numbered 0..1023.

/// 0 .. 2^30 - 1. (Skilling, "Programming the Hilbert curve", 2004.)
[[nodiscard]] std::uint32_t hilbertIndex(glm::uvec3 cell);

} // namespace hairpaint::sim
