// What the light on skin depends on besides the position.
#pragma once

#include "view/rendering/light/environment.h"
#include "view/rendering/light/far_light.h"

namespace hairpaint::rendering {

/// Wo, m; colours linear; see rendering::SkinShading for the rest.
struct SkinLighting
{
    glm::mat3 woFromHd{1.0F};
    glm::vec3 eyeWo{0.0F};
    FarLight key, fill, rim; ///< As on hair.
    Irradiance around{};
    glm::vec3 colour{0.5F};
    glm::vec3 lips{0.5F};
    glm::vec3 lids{0.5F};
    float scatter = 0.0F;
    float grain = 0.0F;
    float sheen = 0.0F;
};

} // namespace hairpaint::rendering
