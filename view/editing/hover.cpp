// Tells both areas, and the tool that waits for the pointer.
#include "view/editing/hover.h"

#include "view/editing/edit_target.h"
#include "view/editing/tool_box.h"
#include "view/editing/view_options.h"

namespace hairpaint::view {

Hover::Hover(const EditTarget& target, ToolBox& tools, const ViewOptions& options, QObject* parent)
    : QObject(parent), m_target(target), m_tools(tools), m_options(options)
{}

void Hover::set(const std::optional<HoverPoint>& at)
{
    if (!at && !m_at)
        return;
    m_at = at;
    Q_EMIT changed();
    std::optional<model::ToolEvent> event;
    if (at)
        event = {.area = at->area, .uv = at->uv, .point = at->point, .pixelM = at->pixelM};
    m_tools.hover(event);
}

std::vector<sim::SurfacePoint> Hover::ringPoints() const
{
    if (!m_at || !m_at->point || m_at->hair || !m_tools.active().traits().hasRing)
        return {};
    std::vector<sim::SurfacePoint> points{*m_at->point};
    const std::shared_ptr<const model::Head>& head = m_target.document().project().head;
    if (m_options.mirror() && head && head->skin) {
        if (const std::optional<sim::SurfacePoint> twin = head->skin->mirrored(*m_at->point))
            points.push_back(*twin);
    }
    return points;
}

} // namespace hairpaint::view
