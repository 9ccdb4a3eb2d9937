// The waves of gusts and turbulence in space.
#include "sim/solver/wind_phases.h"

#include "sim/base/deterministic.h"

#include <glm/gtc/constants.hpp>

#include <cmath>

namespace hairpaint::sim {

namespace {

// rad/m over the head, rad from root to tip.
constexpr glm::vec3 kGustWave{3.1F, 1.3F, 4.2F};
constexpr glm::vec3 kWaveA{9.0F, 13.0F, 11.0F};
constexpr glm::vec3 kWaveB{-23.0F, 14.0F, 19.0F};
constexpr float kAlongA = 2.4F;
constexpr float kAlongB = 4.1F;

} // namespace

float wrappedPhase(float phaseRad)
{
    const float turns = phaseRad * static_cast<float>(1.0 / glm::two_pi<double>());
    return (turns - std::floor(turns)) * static_cast<float>(glm::two_pi<double>());
}

WindPhases windPhases(glm::vec3 rootHd, float hash01)
{
    const float jitter = hash01 * 1.2F;
    return {wrappedPhase(glm::dot(kGustWave, rootHd)), wrappedPhase(glm::dot(kWaveA, rootHd) + jitter),
            wrappedPhase(glm::dot(kWaveB, rootHd) + 2.0F * jitter)};
}

void setWaveTables(GroupGains& gains)
{
    for (int i = 0; i < gains.nodes; ++i) {
        const auto node = static_cast<std::size_t>(i);
        const float fraction = static_cast<float>(i) / static_cast<float>(gains.nodes - 1);
        // A lag: the wave at the root reaches the tip later.
        gains.waveACos[node] = cosDet(kAlongA * fraction);
        gains.waveASin[node] = sinDet(kAlongA * fraction);
        gains.waveBCos[node] = cosDet(kAlongB * fraction);
        gains.waveBSin[node] = sinDet(kAlongB * fraction);
    }
}

} // namespace hairpaint::sim
