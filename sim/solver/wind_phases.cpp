// Locks, and the waves of gusts and turbulence over the head.
#include "sim/solver/wind_phases.h"

#include "sim/base/deterministic.h"

#include <glm/gtc/constants.hpp>

#include <cmath>
#include <cstdint>
#include <limits>

namespace hairpaint::sim {

namespace {

constexpr float kLockM = 0.028F; ///< About how wide a lock is at the roots.

// rad/m over the head, rad between locks, rad from root to tip.
constexpr glm::vec3 kGustWave{5.1F, 2.3F, 6.2F};
constexpr glm::vec3 kWaveA{9.0F, 13.0F, 11.0F};
constexpr glm::vec3 kWaveB{-23.0F, 14.0F, 19.0F};
constexpr float kGustOfLock = 1.6F;
constexpr float kWaveOfLock = 2.8F;
constexpr float kWaveOfStrand = 0.8F;
constexpr float kAlongA = 2.4F;
constexpr float kAlongB = 4.1F;

/// What a lock has of its own, 0..1 each.
struct Lock
{
    float timing = 0.0F;
    float strength = 0.0F;
};

/// That whose middle is the nearest: one middle somewhere in each cell of a grid.
Lock lockAt(glm::vec3 rootHd)
{
    const glm::ivec3 own(glm::floor(rootHd / kLockM));
    float nearest2 = std::numeric_limits<float>::max();
    std::uint64_t number = 0;
    for (int n = 0; n < 27; ++n) {
        const glm::ivec3 cell = own + glm::ivec3(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
        const auto bits = [](int v) { return static_cast<std::uint64_t>(static_cast<std::uint32_t>(v)); };
        const std::uint64_t hash = hash64(bits(cell.x) << 32U | bits(cell.y), bits(cell.z));
        const glm::vec3 inCell(unitFloat(hash), unitFloat(hash64(hash, 1)), unitFloat(hash64(hash, 2)));
        const glm::vec3 away = (glm::vec3(cell) + inCell) * kLockM - rootHd;
        const float square = glm::dot(away, away);
        if (square < nearest2) {
            nearest2 = square;
            number = hash;
        }
    }
    return {unitFloat(hash64(number, 3)), unitFloat(hash64(number, 4))};
}

} // namespace

float wrappedPhase(float phaseRad)
{
    const float turns = phaseRad * static_cast<float>(1.0 / glm::two_pi<double>());
    return (turns - std::floor(turns)) * static_cast<float>(glm::two_pi<double>());
}

WindPhases windPhases(glm::vec3 rootHd, float hash01, float height)
{
    const Lock lock = lockAt(rootHd);
    const float wave = lock.timing * kWaveOfLock + hash01 * kWaveOfStrand;
    return {.gust = wrappedPhase(glm::dot(kGustWave, rootHd) + lock.timing * kGustOfLock),
            .a = wrappedPhase(glm::dot(kWaveA, rootHd) + wave),
            .b = wrappedPhase(glm::dot(kWaveB, rootHd) + 2.0F * wave),
            .exposure = (0.6F + 0.8F * lock.strength) * (0.5F + 0.6F * height)};
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
