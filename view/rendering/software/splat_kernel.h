// Lays strands into the voxels of the opacity grids.
#pragma once

#include "view/rendering/eye_grid.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace hairpaint::rendering {

/// Every `step`th strand of a group from `first` on.
struct SplatTask
{
    glm::mat4 gridFromWo{1.0F}; ///< From the world to the light's grid.
    glm::mat4 projectionFromWo{1.0F};
    EyeGrid eyeGrid;
    const sim::GroupFrame* group = nullptr;
    std::span<const std::uint32_t> slots;
    std::size_t first = 0;
    std::size_t step = 1;
    int nodes = 2;
    float weight = 0.0F; ///< Area that a metre of a strand adds to the voxels, in their units.
};
/// Adds the strands' areas to the voxels of both grids.
void splatStrands(const SplatTask& task, std::uint32_t* voxels);

} // namespace hairpaint::rendering
