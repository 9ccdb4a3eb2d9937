// Hair without a window: see the header.
#include "app/cli/settled_hair.h"

#include "model/document.h"
#include "sim/groom/even_subset.h"

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

void SettledHair::advance(double seconds)
{
    m_simulation.settle(seconds);
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
