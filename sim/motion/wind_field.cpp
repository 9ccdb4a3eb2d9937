// Gusts, turbulence and puffs.
#include "sim/motion/wind_field.h"

#include "sim/base/deterministic.h"
#include "sim/motion/head_motion.h"
#include "sim/solver/wind_phases.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace hairpaint::sim {

namespace {

constexpr auto kStep = static_cast<float>(kStepSeconds);
constexpr float kStrongestWind = 60.0F;
constexpr int kPuffSteps = 12;

// Angular frequencies of the waves in time, rad/s; those in space are in solver/wind_phases.
constexpr double kGustRate = 1.7;
constexpr double kRateA = 6.3;
constexpr double kRateB = 11.9;

bool isFinite(glm::vec3 v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

glm::vec3 limitedSpeed(glm::vec3 v)
{
    const float square = glm::dot(v, v);
    if (!std::isfinite(square))
        return glm::vec3(0.0F);
    return square > kStrongestWind * kStrongestWind ? v * (kStrongestWind / std::sqrt(square)) : v;
}

std::array<float, 3> toArray(glm::vec3 v)
{
    return {v.x, v.y, v.z};
}

/// Phase of a wave after so many steps, 0..2 pi.
float phaseAfter(std::uint64_t steps, double radPerSecond)
{
    const double turns = static_cast<double>(steps) * (kStepSeconds * radPerSecond / glm::two_pi<double>());
    return static_cast<float>((turns - std::floor(turns)) * glm::two_pi<double>());
}

/// Any unit vector across v.
glm::vec3 acrossOf(glm::vec3 v)
{
    const glm::vec3 helper = std::abs(v.y) < 0.8F * std::sqrt(glm::dot(v, v)) ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 across = glm::cross(v, helper);
    return across / std::sqrt(std::max(glm::dot(across, across), 1e-20F));
}

} // namespace

void WindField::setWind(const Wind& wind)
{
    m_wind = wind;
    m_wind.velocity = isFinite(wind.velocity) ? limitedSpeed(wind.velocity) : glm::vec3(0.0F);
    m_wind.gustiness = std::isfinite(wind.gustiness) ? std::clamp(wind.gustiness, 0.0F, 1.0F) : 0.0F;
    m_wind.turbulence = std::isfinite(wind.turbulence) ? std::clamp(wind.turbulence, 0.0F, 1.0F) : 0.0F;
    if (glm::dot(m_wind.velocity, m_wind.velocity) < 1e-8F)
        m_wind.enabled = false;
}

void WindField::puff(glm::vec3 centreWo, glm::vec3 velocity, float radiusM)
{
    if (!isFinite(centreWo) || !isFinite(velocity) || !std::isfinite(radiusM) || radiusM <= 1e-4F)
        return;
    if (m_blows.size() == kMaxPuffs)
        m_blows.erase(m_blows.begin());
    m_blows.push_back({centreWo, limitedSpeed(velocity), radiusM, kPuffSteps});
}

bool WindField::blows() const
{
    return m_wind.enabled || !m_blows.empty();
}

StepForces WindField::calm(const HeadPose& pose)
{
    StepForces forces;
    forces.gravity = toArray(directionToHead(pose, {0.0F, -kGravity * kStep * kStep, 0.0F}));
    return forces;
}

StepForces WindField::nextStep(const HeadPose& from, const HeadPose& to)
{
    StepForces forces = calm(to);
    forces.toNewHead = inertialMotion(from, to);
    forces.windy = blows();
    if (m_wind.enabled) {
        const double seconds = static_cast<double>(m_step) * kStepSeconds;
        // Two slow waves whose sum never repeats; -1..1.
        const float lull =
            0.6F * sinDet(wrappedPhase(static_cast<float>(std::fmod(seconds * 0.83, glm::two_pi<double>())))) +
            0.4F * sinDet(wrappedPhase(static_cast<float>(std::fmod(seconds * 2.17 + 1.3, glm::two_pi<double>()))));
        const float everywhere = 1.0F - m_wind.gustiness * 0.35F * (1.0F - lull);
        const glm::vec3 windHd = directionToHead(to, m_wind.velocity * (everywhere * kStep));
        const float speed = std::sqrt(glm::dot(windHd, windHd));
        forces.wind = toArray(windHd);
        forces.gust = 0.8F * m_wind.gustiness;
        const glm::vec3 across = acrossOf(windHd);
        const glm::vec3 third = glm::cross(windHd, across) / std::max(speed, 1e-12F);
        const float swirl = m_wind.turbulence * speed;
        forces.swirlA = toArray((across * 0.8F + third * 0.3F) * swirl);
        forces.swirlB = toArray((third * 0.5F + across * -0.25F + windHd / std::max(speed, 1e-12F) * 0.4F) * swirl);
        forces.phaseGust = phaseAfter(m_step, kGustRate);
        forces.phaseA = phaseAfter(m_step, kRateA);
        forces.phaseB = phaseAfter(m_step, kRateB);
    }
    for (Blow& blow : m_blows) {
        PuffForces& to3 = forces.puffs[static_cast<std::size_t>(forces.puffCount++)];
        to3.centre = toArray(pointToHead(to, blow.centreWo));
        const float fading = static_cast<float>(blow.stepsLeft) / static_cast<float>(kPuffSteps);
        to3.velocity = toArray(directionToHead(to, blow.velocity * (kStep * fading)));
        to3.inverseRadius2 = 1.0F / (blow.radiusM * blow.radiusM);
        --blow.stepsLeft;
    }
    std::erase_if(m_blows, [](const Blow& blow) { return blow.stepsLeft <= 0; });
    ++m_step;
    return forces;
}

} // namespace hairpaint::sim
