// A grid of distances as kernels read it.
#pragma once

#include "sim/skin/distance_grid.h"

#include <array>
#include <cstdint>

namespace hairpaint::sim {

/// A DistanceGrid, of which the kernels read two pairs at once. Must not outlive the grid.
struct SkinField
{
    const DistanceGrid::Pair* pairs = nullptr; ///< [z][y][x], null where there is no grid.
    std::array<float, 3> origin{};
    std::array<float, 3> last{}; ///< Coordinates in cells lie in 0..last, the end excluded.
    float cellM = 1.0F;
    float inverseCell = 1.0F; ///< 1/m
    std::int32_t row = 0;     ///< Pairs from one y to the next.
    std::int32_t slice = 0;   ///< Pairs from one z to the next.
    float unitsACell = 1.0F;  ///< A cell's side, in units of the values.
    /// A cell's diagonal in those units: no value in a cell differs by more from one at its corners.
    float unitsADiagonal = 1.0F;
};

[[nodiscard]] SkinField skinFieldOf(const DistanceGrid& grid);

} // namespace hairpaint::sim
