// Starts, jumps and dab positions of a brush's path.
#include "model/tools/brush_path.h"

namespace hairpaint::model {

namespace {

constexpr float kLeapM = 0.06F; ///< A pointer that moves further over the head at once has left the surface between.

} // namespace

BrushPath::BrushPath(const sim::Skin* skin, float spacingM, float leastStepUv)
    : m_skin(skin), m_spacingM(spacingM), m_leastStepUv(leastStepUv)
{
    if (skin != nullptr)
        m_last.metric = SkinMetric::average(*skin);
}

BrushPath::Cursor BrushPath::cursorOf(const ToolEvent& event)
{
    const bool onSkin = event.point.has_value();
    return {event.uv, onSkin ? event.point->positionHd : glm::vec3(0.0F), onSkin, event.pressure};
}

void BrushPath::start(const ToolEvent& event)
{
    m_cursor = cursorOf(event);
    m_last = event.area == Area::Head && event.point ? sampleAt(*event.point, event.pressure)
                                                     : sampleAtUv(event.uv, event.pressure);
    m_carriedM = 0.0F;
}

/// On the 3D head, a step in uv much longer than on the skin has crossed a seam or to another island.
bool BrushPath::jumpsInUv(const ToolEvent& event) const
{
    if (event.area != Area::Head || !m_cursor->onSkin || m_skin == nullptr)
        return false;
    const float chordM = glm::length(event.point->positionHd - m_cursor->positionHd);
    return m_last.metric.lengthM(event.uv - m_cursor->uv) > 3.0F * chordM + 0.002F;
}

bool BrushPath::leaps(const ToolEvent& event) const
{
    return jumpsInUv(event) && glm::length(event.point->positionHd - m_cursor->positionHd) > kLeapM;
}

BrushSample BrushPath::sampleAtUv(glm::vec2 uv, float pressure) const
{
    if (m_skin != nullptr)
        if (const std::optional<sim::SurfacePoint> point = m_skin->atUv(uv))
            return {uv, point, SkinMetric::at(*point), pressure};
    // Off the islands the size on the last island goes on.
    return {uv, std::nullopt, m_last.metric, pressure};
}

BrushSample BrushPath::sampleAt(const sim::SurfacePoint& point, float pressure) const
{
    return {point.uv, point, SkinMetric::at(point), pressure};
}

} // namespace hairpaint::model
