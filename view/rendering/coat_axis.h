// From where the coat of hair faces outward, in the opacity grids.
#pragma once

#include "view/rendering/eye_grid.h"

#include <array>

namespace hairpaint::rendering {

/// Points are looked up this far outside the coat, in voxels, so that no strand shades itself and its neighbours: on
/// the grid's z, and across it where the coat stands steep in the grid. There z alone stays within the coat's own
/// voxels, whose columns would be seen as bands.
inline constexpr float kOutOfCoatVoxels = 1.5F;

/// The middle of the head, and the line down from there about which hair hangs. In a grid, 0..1.
struct CoatAxis
{
    glm::vec3 middle{0.5F};
    glm::vec3 down{0.0F, -1.0F, 0.0F};    ///< Any length but 0,
    glm::vec3 perDown{0.0F, -1.0F, 0.0F}; ///< and that over its square.
};

/// In the light's grid (0) and the eye's (1).
[[nodiscard]] std::array<CoatAxis, 2> coatAxes(const FrameConstants& constants);

} // namespace hairpaint::rendering
