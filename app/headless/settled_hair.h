// A project's hair without a window: groomed, let fall, and stepped on by hand.
#pragma once

#include "model/project/project.h"
#include "sim/motion/neck_motion.h"
#include "sim/motion/simulation.h"

#include <optional>

namespace hairpaint::app {

struct SettleOptions
{
    std::optional<std::size_t> hairs;      ///< An even subset of those that are there; else all.
    std::optional<glm::vec3> windVelocity; ///< Wo, m/s; else the project's own wind.
};

class SettledHair
{
public:
    /// With 0 seconds the hair keeps its rest shape.
    SettledHair(model::Project project, double settleSeconds, const SettleOptions& options = {});

    [[nodiscard]] const model::Project& project() const { return m_project; }
    /// From now on the head repeats this motion while time passes; none: it looks straight ahead.
    void setMotion(std::optional<sim::NeckMotion> motion);
    void advance(double seconds);
    [[nodiscard]] std::shared_ptr<const sim::StrandFrame> frame() const;

private:
    model::Project m_project;
    std::optional<std::size_t> m_hairs;
    sim::Simulation m_simulation;
    std::optional<sim::NeckMotion> m_motion;
    long m_motionSteps = 0; ///< Steps since the motion began.
};

} // namespace hairpaint::app
