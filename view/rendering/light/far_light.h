// The part of the light that hair and skin both use.
#pragma once

#include <glm/glm.hpp>

#include <cstdint>

namespace hairpaint::rendering {

/// Far away, or so large that it makes no difference.
struct FarLight
{
    glm::vec3 towardWo{0.0F, 1.0F, 0.0F}; ///< Unit.
    glm::vec3 colour{0.0F};               ///< Linear: what a white surface shows at right angles to it.
};

/// How a hair scatters light.
enum class ScatteringModel : std::uint8_t
{
    Marschner,
    KajiyaKay,
    IlluminatedLines
};

} // namespace hairpaint::rendering
