// A project's hair without a window: groomed, let fall, and stepped on by hand.
#pragma once

#include "model/project.h"
#include "sim/motion/simulation.h"

namespace hairpaint::app {

class SettledHair
{
public:
    /// With 0 seconds the hair keeps its rest shape.
    SettledHair(model::Project project, double settleSeconds);

    [[nodiscard]] const model::Project& project() const { return m_project; }
    void advance(double seconds);
    [[nodiscard]] std::shared_ptr<const sim::StrandFrame> frame() const;

private:
    model::Project m_project;
    sim::Simulation m_simulation;
};

} // namespace hairpaint::app
