// Hair without a window: see the header.
#include "app/headless/settled_hair.h"

#include "model/document/document.h"
#include "sim/groom/even_subset.h"
#include "sim/solver/solver_layout.h"

#include <cmath>

namespace hairpaint::app {

SettledHair::SettledHair(model::Project project, double settleSeconds, const SettleOptions& options)
    : m_project(std::move(project)), m_hairs(options.hairs)
{
    if (options.windVelocity) {
        m_project.wind.enabled = true;
        m_project.wind.velocity = *options.windVelocity;
    }
    m_simulation.setInput(model::Document(m_project).groomInput());
    m_simulation.setWind(m_project.wind);
    m_simulation.reset();
    if (settleSeconds > 0.0)
        m_simulation.settle(settleSeconds);
}

void SettledHair::setMotion(std::optional<sim::NeckMotion> motion)
{
    m_motion = motion;
    m_motionSteps = 0;
    if (!motion)
        m_simulation.setPose({});
}

void SettledHair::advance(double seconds)
{
    if (!m_motion) {
        m_simulation.settle(seconds);
        return;
    }
    const auto stepsOf = [](double time) { return std::lround(time / sim::kStepSeconds); };
    const sim::Neck neck = sim::neckOf(m_project.head->landmarks, m_project.head->skin->mesh());
    // A pose for every step, so that a film is the same motion at every rate.
    for (long left = stepsOf(seconds); left > 0; --left) {
        ++m_motionSteps;
        const long phase = m_motionSteps % stepsOf(sim::secondsOf(*m_motion));
        const double time = static_cast<double>(phase) * sim::kStepSeconds;
        m_simulation.setPose(sim::poseOn(neck, sim::anglesAt(*m_motion, time)));
        m_simulation.settle(sim::kStepSeconds);
    }
}

std::shared_ptr<const sim::StrandFrame> SettledHair::frame() const
{
    auto frame = std::make_shared<sim::StrandFrame>();
    m_simulation.writeFrame(*frame);
    if (m_hairs) {
        std::vector<std::shared_ptr<const sim::Groom>> grooms;
        for (const sim::GroupFrame& group : frame->groups)
            grooms.push_back(group.groom);
        grooms = sim::evenSubset(grooms, *m_hairs);
        for (std::size_t i = 0; i < grooms.size(); ++i)
            frame->groups[i].groom = grooms[i];
    }
    return frame;
}

} // namespace hairpaint::app
