// Takes the head's middle into the grids.
#include "view/rendering/coat_axis.h"

#include <algorithm>

namespace hairpaint::rendering {

std::array<CoatAxis, 2> coatAxes(const FrameConstants& constants)
{
    const EyeGrid eye = eyeGrid(constants);
    constexpr float kDownM = 0.1F;
    constexpr float kNearestM = 0.02F;
    const glm::vec4 middleWo(glm::vec3(constants.headWo), 1.0F);
    const glm::vec4 belowWo = middleWo - glm::vec4(0.0F, kDownM, 0.0F, 0.0F);
    const auto fromEye = [&](glm::vec4 wo) {
        const glm::vec4 clip = constants.projectionFromWo * wo;
        const float awayM = std::max(clip.w, kNearestM);
        return (glm::vec3(clip.x / awayM, clip.y / awayM, clip.w) - eye.low) * eye.per;
    };
    const auto axis = [](glm::vec3 middle, glm::vec3 below) {
        const glm::vec3 down = below - middle;
        return CoatAxis{.middle = middle, .down = down, .perDown = down / std::max(glm::dot(down, down), 1e-12F)};
    };
    const glm::mat4& light = constants.gridFromWo[0];
    return {axis(glm::vec3(light * middleWo), glm::vec3(light * belowWo)), axis(fromEye(middleWo), fromEye(belowWo))};
}

} // namespace hairpaint::rendering
