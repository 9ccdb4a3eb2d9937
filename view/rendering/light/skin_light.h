// What the light on skin depends on besides the place.
#pragma once

#include <glm/glm.hpp>

namespace hairpaint::rendering {

/// Wo, m; colours linear; see rendering::Skin for the rest.
struct SkinLighting
{
    glm::mat3 woFromHd{1.0F};
    glm::vec3 eyeWo{0.0F};
    glm::vec3 lightWo{0.0F, 1.0F, 0.0F}; ///< Toward the light, unit.
    glm::vec3 lightColour{1.0F};
    glm::vec3 colour{0.5F};
    glm::vec3 lips{0.5F};
    glm::vec3 lids{0.5F};
    float ambient = 0.35F;
    float scatter = 0.0F;
    float grain = 0.0F;
    float sheen = 0.0F;
};

} // namespace hairpaint::rendering
