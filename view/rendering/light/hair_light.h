// What the light on hair depends on besides the position.
#pragma once

#include "view/rendering/light/environment.h"
#include "view/rendering/light/far_light.h"
#include "view/rendering/light/fibre_shape.h"

namespace hairpaint::rendering {

inline constexpr float kGridUnits = 1024.0F; ///< Units of a voxel's opacity of 1; opacities over 64 are stored as 64.

/// Wo, m; colours linear.
struct HairLighting
{
    glm::vec3 eyeWo{0.0F};
    FarLight key;
    FarLight fill; ///< From about where the eye is.
    FarLight rim;  ///< From behind what the eye sees.
    Irradiance around{};
    glm::vec3 headWo{0.0F}; ///< The middle that the coat faces away from.
    float headRadiusM = 0.0F;
    ScatteringModel scattering = ScatteringModel::Marschner;
    float shine = 0.5F; ///< 0..1; a natural hair's is 0.5.
    FibreShape shape = fibreShape(0.3F);
    /// Exponent of the highlight in Kajiya and Kay's model and that of illuminated lines.
    float highlightExponent = 182.0F;
};

/// Exponent of a highlight that is as wide as the fibre shape's.
[[nodiscard]] constexpr float highlightExponent(float roughness)
{
    const float deviation = 0.02F + 0.18F * roughness;
    return 1.0F / (deviation * deviation);
}

} // namespace hairpaint::rendering
