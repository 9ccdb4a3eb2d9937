// Bounds the hair's box in the picture.
#include "view/rendering/eye_grid.h"

#include <algorithm>

namespace hairpaint::rendering {

EyeGrid eyeGrid(const FrameConstants& constants)
{
    /// Where the grid ends, in half the picture's size: hair further out hides nothing that is seen.
    constexpr float kEdge = 1.1F;
    constexpr float kNearestM = 0.02F;
    constexpr float kLeastExtent = 0.01F;
    const glm::mat4 woFromBox = glm::inverse(constants.gridFromWo[1]);
    const glm::mat4& m = constants.projectionFromWo;
    glm::vec3 low(1e9F);
    glm::vec3 high(-1e9F);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec4 box(static_cast<float>(corner & 1), static_cast<float>((corner >> 1) & 1),
                            static_cast<float>(corner >> 2), 1.0F);
        const glm::vec4 clip = m * (woFromBox * box);
        const bool behind = clip.w < kNearestM; // A corner behind the eye may lie anywhere in the picture.
        const glm::vec3 projected(clip.x / std::max(clip.w, kNearestM), clip.y / std::max(clip.w, kNearestM), clip.w);
        low = glm::min(low, behind ? glm::vec3(-kEdge, -kEdge, kNearestM) : projected);
        high = glm::max(high, behind ? glm::vec3(kEdge, kEdge, kNearestM) : projected);
    }
    low = glm::max(low, glm::vec3(-kEdge, -kEdge, kNearestM));
    high = glm::min(high, glm::vec3(kEdge, kEdge, 1e6F));
    const glm::vec3 extent = glm::max(high - low, glm::vec3(kLeastExtent));
    const float scaleX = glm::length(glm::vec3(m[0][0], m[1][0], m[2][0]));
    const float scaleY = glm::length(glm::vec3(m[0][1], m[1][1], m[2][1]));
    return {.low = low,
            .per = 1.0F / extent,
            .sectionM2 = extent.x * extent.y / (scaleX * scaleY * static_cast<float>(kGridSide * kGridSide)),
            .middleM = low.z + 0.5F * extent.z};
}

} // namespace hairpaint::rendering
