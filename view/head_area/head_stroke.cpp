// Looks for gaps in the skin between a stroke's events.
#include "view/head_area/head_stroke.h"

#include "view/editing/editor_state.h"
#include "view/head_area/head_scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hairpaint::view {

namespace {

constexpr double kProbePx = 3.0; ///< A gap in the skin narrower than this may be bridged by a stroke.
constexpr int kMostProbes = 400;
constexpr float kBehindM = 0.03F; ///< So much further at the next probe lies behind, or in front of, the last one.

/// Whether a stroke breaks between two neighbouring points of the screen.
bool breaksBetween(const std::optional<sim::SurfacePoint>& a, const std::optional<sim::SurfacePoint>& b)
{
    return a.has_value() != b.has_value() || (a && b && glm::length(a->positionHd - b->positionHd) > kBehindM);
}

PointerSample between(const PointerSample& from, const PointerSample& to, double fraction)
{
    PointerSample sample = to;
    sample.position = from.position + (to.position - from.position) * fraction;
    sample.pressure = from.pressure + (to.pressure - from.pressure) * static_cast<float>(fraction);
    sample.seconds = from.seconds + (to.seconds - from.seconds) * fraction;
    return sample;
}

} // namespace

void HeadStroke::press(const PointerSample& sample, const std::optional<model::GrabbedHair>& grabbed)
{
    m_at = sample;
    m_grabbed = grabbed;
    m_began.reset();
    m_overHair = false;
    if (m_grabbed)
        m_editor.tools().press(hairEvent(sample));
    else if (const std::optional<model::ToolEvent> event = strandsEvent(sample))
        m_editor.tools().press(*event);
    else
        m_editor.tools().press(toolEvent(sample, m_scene.skinAt(sample.position)));
}

void HeadStroke::move(const PointerSample& sample)
{
    if (!m_editor.tools().stroking())
        return;
    PointerSample from = std::exchange(m_at, sample);
    if (m_grabbed)
        return m_editor.tools().move(hairEvent(sample));
    const bool wasOverHair = m_overHair;
    if (const std::optional<model::ToolEvent> event = strandsEvent(sample))
        return m_editor.tools().move(*event);
    if (wasOverHair)
        from = sample; // Over the skin it begins anew.
    const QPointF moved = sample.position - from.position;
    const int steps = std::clamp(static_cast<int>(std::hypot(moved.x(), moved.y()) / kProbePx), 1, kMostProbes);
    PointerSample last = from;
    std::optional<sim::SurfacePoint> lastPoint = m_scene.skinAt(from.position);
    for (int i = 1; i <= steps; ++i) {
        const PointerSample probe = i == steps ? sample : between(from, sample, static_cast<double>(i) / steps);
        const std::optional<sim::SurfacePoint> point = m_scene.skinAt(probe.position);
        if (breaksBetween(lastPoint, point)) {
            if (lastPoint)
                m_editor.tools().move(toolEvent(last, lastPoint));
            m_editor.tools().move(toolEvent(probe, std::nullopt));
            if (point)
                m_editor.tools().move(toolEvent(probe, point));
        }
        last = probe;
        lastPoint = point;
    }
    m_editor.tools().move(toolEvent(sample, lastPoint));
}

void HeadStroke::release(const PointerSample& sample)
{
    PointerSample last = sample;
    last.pressure = m_at.pressure; // A pen that is lifted has none left.
    move(last);
    if (m_grabbed)
        m_editor.tools().release(hairEvent(sample));
    else if (const std::optional<model::ToolEvent> event = strandsEvent(last))
        m_editor.tools().release(*event);
    else
        m_editor.tools().release(toolEvent(sample, m_scene.skinAt(sample.position)));
}

/// Off the skin the uv is the last one.
model::ToolEvent HeadStroke::toolEvent(const PointerSample& sample, const std::optional<sim::SurfacePoint>& point)
{
    if (point)
        m_lastUv = point->uv;
    model::ToolEvent event{.area = model::Area::Head,
                           .uv = m_lastUv,
                           .point = point,
                           .pressure = sample.pressure,
                           .seconds = sample.seconds,
                           .modifiers = sample.modifiers,
                           .again = sample.again};
    if (point)
        event.pixelM = m_scene.pixelAt(*point);
    return event;
}

std::optional<model::ToolEvent> HeadStroke::strandsEvent(const PointerSample& sample)
{
    const std::optional<model::OverHair> hair = m_scene.overHair(sample.position, m_began);
    m_overHair = hair.has_value();
    if (!hair)
        return std::nullopt;
    if (!m_began)
        m_began = hair;
    model::ToolEvent event = toolEvent(sample, std::nullopt);
    event.hair = hair;
    return event;
}

model::HairEvent HeadStroke::hairEvent(const PointerSample& sample) const
{
    return {.hair = *m_grabbed,
            .targetHd = m_scene.besideHd(m_grabbed->positionHd, sample.position),
            .modifiers = sample.modifiers};
}

} // namespace hairpaint::view
