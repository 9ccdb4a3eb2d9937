// Gusts and turbulence in space: how far each lock, each strand of it and each node lags behind.
#pragma once

#include "sim/solver/solver_layout.h"

#include <glm/glm.hpp>

namespace hairpaint::sim {

/// A phase as the kernel takes it, 0..2 pi.
[[nodiscard]] float wrappedPhase(float phaseRad);

/// How the moving air meets a strand.
struct WindPhases
{
    float gust = 0.0F; ///< By how much gusts and the two waves of turbulence lag, 0..2 pi.
    float a = 0.0F;
    float b = 0.0F;
    float exposure = 1.0F; ///< Fraction of the wind's strength that gets to it; about 1 on average.
};
/// Strands that grow within a few centimetres of each other make a lock, which the air moves as one. `hash01` is the
/// strand's own; `height` how high in the coat it lies, 0..1: what lies deeper is sheltered.
[[nodiscard]] WindPhases windPhases(glm::vec3 rootHd, float hash01, float height);

/// The phases by which the two waves of turbulence lag at a node, as tables.
void setWaveTables(GroupGains& gains);

} // namespace hairpaint::sim
