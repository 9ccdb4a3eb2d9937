// The forces of each step: gravity, and the air with its gusts, turbulence and puffs.
#pragma once

#include "sim/motion/strand_frame.h"
#include "sim/motion/wind.h"
#include "sim/solver/solver_layout.h"

#include <cstdint>
#include <vector>

namespace hairpaint::sim {

/// Deterministic: the same steps give the same wind. Gusts come and go over seconds, everywhere and in waves over the
/// head; turbulence is two waves that run over the head and along each strand, out of step from hair to hair.
class WindField
{
public:
    /// Numbers that are not finite count as no wind; speeds are limited to 60 m/s.
    void setWind(const Wind& wind);
    /// Lasts a tenth of a second; the oldest is dropped where there are more than kMaxPuffs.
    void puff(glm::vec3 centreWo, glm::vec3 velocity, float radiusM);
    [[nodiscard]] bool blows() const;

    /// The forces of the next step, in which the head goes from one pose to the other.
    [[nodiscard]] StepForces nextStep(const HeadPose& from, const HeadPose& to);
    /// Gravity alone, for settling.
    [[nodiscard]] static StepForces calm(const HeadPose& pose);

private:
    struct Blow
    {
        glm::vec3 centreWo{0.0F};
        glm::vec3 velocity{0.0F};
        float radiusM = 0.0F;
        int stepsLeft = 0;
    };
    Wind m_wind{.enabled = false};
    std::vector<Blow> m_blows;
    std::uint64_t m_step = 0;
};

} // namespace hairpaint::sim
