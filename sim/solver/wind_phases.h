// The waves of gusts and turbulence in space: how far each strand and each node lags behind.
#pragma once

#include "sim/solver/solver_layout.h"

#include <glm/glm.hpp>

namespace hairpaint::sim {

/// A phase as the kernel takes it, 0..2 pi.
[[nodiscard]] float wrappedPhase(float phaseRad);

/// By how much gusts and the two waves of turbulence lag at a root, 0..2 pi.
struct WindPhases
{
    float gust = 0.0F;
    float a = 0.0F;
    float b = 0.0F;
};
[[nodiscard]] WindPhases windPhases(glm::vec3 rootHd, float hash01);

/// The phases by which the two waves of turbulence lag at a node, as tables.
void setWaveTables(GroupGains& gains);

} // namespace hairpaint::sim
