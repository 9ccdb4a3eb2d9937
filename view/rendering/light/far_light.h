// The lights that hair and skin share.
#pragma once

#include "view/rendering/frame_constants.h"

namespace hairpaint::rendering {

/// Far away, or so large that it makes no difference.
struct FarLight
{
    glm::vec3 towardWo{0.0F, 1.0F, 0.0F}; ///< Unit.
    glm::vec3 colour{0.0F};               ///< Linear: what a white surface shows at right angles to it.
};

[[nodiscard]] inline Irradiance irradianceIn(const FrameConstants& constants)
{
    Irradiance around{};
    for (std::size_t i = 0; i < around.size(); ++i)
        around.at(i) = glm::vec3(constants.around.at(i));
    return around;
}

} // namespace hairpaint::rendering
