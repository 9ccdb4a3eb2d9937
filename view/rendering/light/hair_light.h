// What the light on hair depends on besides the place.
#pragma once

#include <glm/glm.hpp>

namespace hairpaint::rendering {

inline constexpr float kGridUnits = 1024.0F; ///< That a voxel's opacity is counted in; 64 and more is 64.

/// Wo, m; colours linear.
struct HairLighting
{
    glm::vec3 eyeWo{0.0F};
    glm::vec3 lightWo{0.0F, 1.0F, 0.0F}; ///< Toward the light, unit.
    glm::vec3 lightColour{1.0F};
    glm::vec3 headWo{0.0F}; ///< The middle that the coat faces away from.
    float ambient = 0.35F;
    float shine = 0.5F;
    float roughness = 0.3F;
};

} // namespace hairpaint::rendering
