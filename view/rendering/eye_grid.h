// The voxels of the opacity grid that runs away from the eye.
#pragma once

#include "view/rendering/frame_constants.h"

namespace hairpaint::rendering {

/// Its columns follow the rays through the picture's points, so that what lies before another in a column hides it, and
/// so that there are as many for the part of the hair that is seen, however near the camera is.
/// A position is (normalised device x and y, distance along the view in m), less `low`, times `per`: 0..1.
struct EyeGrid
{
    glm::vec3 low{0.0F};
    glm::vec3 per{1.0F};
    float sectionM2 = 1.0F; ///< That a column covers at a distance of 1 m.
    float middleM = 1.0F;   ///< Distance of the grid's middle from the eye.
};

/// A voxel hides no more than this, in coverings, of what lies behind: many hairs may lie in a small part of its
/// section.
inline constexpr float kMostOfVoxel = 2.5F;
/// And within itself, from its near side to its far one, no more than this: all hairs of a braid are counted in its
/// middle line, before which each of them passes.
inline constexpr float kMostWithinVoxel = 12.0F;

/// Around the hair as `constants` bound it, as far as that lies in the picture.
[[nodiscard]] EyeGrid eyeGrid(const FrameConstants& constants);

} // namespace hairpaint::rendering
