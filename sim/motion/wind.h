// The moving air: a steady direction with gusts and turbulence.
#pragma once

#include <glm/glm.hpp>

namespace hairpaint::sim {

/// Wo, m/s.
struct Wind
{
    bool enabled = true;
    glm::vec3 velocity{0.0F}; ///< Direction and strength; WindField limits it to 60 m/s.
    float gustiness = 0.5F;   ///< 0..1: fraction of the strength that comes and goes over seconds.
    float turbulence = 0.3F;  ///< 0..1: fraction of the strength that varies over space.
    friend bool operator==(const Wind&, const Wind&) = default;
};

} // namespace hairpaint::sim
