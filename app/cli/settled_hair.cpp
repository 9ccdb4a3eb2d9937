// Hair without a window: see the header.
#include "app/cli/settled_hair.h"

#include "model/document.h"

namespace hairpaint::app {

SettledHair::SettledHair(model::Project project, double settleSeconds) : m_project(std::move(project))
{
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
    return frame;
}

} // namespace hairpaint::app
