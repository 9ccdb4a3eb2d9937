// The path of a brush over the skin, from pointer events to evenly spaced positions of dabs.
#pragma once

#include "model/tools/strokes/dab_shape.h"
#include "model/tools/tool.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace hairpaint::model {

/// The position of a dab.
struct BrushSample
{
    glm::vec2 uv{0.0F};
    std::optional<sim::SurfacePoint> point; ///< The point of the skin; none off every island.
    SkinMetric metric;
    float pressure = 1.0F;
};

/// Steps along the straight lines between events in uv, measured on the skin with the metric of the last sample; so
/// however a line is cut into events, the positions are the same. On the 3D head a line that jumps in uv (across a
/// seam) is walked on the skin instead, and one that jumps on the skin too starts anew.
class BrushPath
{
public:
    /// `skin` may be null: then uv units count as 0.5 m. Positions are never nearer than `leastStepUv`, however
    /// stretched the layout is.
    BrushPath(const sim::Skin* skin, float spacingM, float leastStepUv);

    /// The spacing after the next sample; brushes that shrink with pressure step more finely.
    void setSpacing(float spacingM) { m_spacingM = spacingM; }

    /// Appends the positions reached by the event; the first event gives one at once.
    /// `onSample` sees each sample as it is made and may set the spacing.
    template<typename OnSample>
    void moveTo(const ToolEvent& event, const OnSample& onSample)
    {
        if (event.area == Area::Head && !event.point) {
            lift();
            return;
        }
        if (!m_cursor || leaps(event)) {
            start(event);
            onSample(m_last);
        } else if (jumpsInUv(event)) {
            walkOnSkin(event, onSample);
        } else {
            walkInUv(event, onSample);
        }
    }
    /// The next event starts anew.
    void lift() { m_cursor.reset(); }
    /// Stands at the event without giving a sample.
    void standAt(const ToolEvent& event) { start(event); }

private:
    static constexpr float kLeastWalkM = 1e-4F;

    struct Cursor
    {
        glm::vec2 uv;
        glm::vec3 positionHd;
        bool onSkin;
        float pressure;
    };

    void start(const ToolEvent& event);
    [[nodiscard]] bool leaps(const ToolEvent& event) const;
    [[nodiscard]] bool jumpsInUv(const ToolEvent& event) const;
    [[nodiscard]] BrushSample sampleAtUv(glm::vec2 uv, float pressure) const;
    [[nodiscard]] BrushSample sampleAt(const sim::SurfacePoint& point, float pressure) const;
    [[nodiscard]] static Cursor cursorOf(const ToolEvent& event);

    template<typename OnSample>
    void walkInUv(const ToolEvent& event, const OnSample& onSample)
    {
        const Cursor end = cursorOf(event);
        for (;;) {
            const float aheadUv = glm::length(end.uv - m_cursor->uv);
            const float ahead = m_last.metric.lengthM(end.uv - m_cursor->uv);
            if (!(ahead > 0.0F))
                break;
            const float spacingM = std::max(m_spacingM, m_leastStepUv * ahead / aheadUv);
            if (m_carriedM + ahead < spacingM)
                break;
            const float fraction = std::max(0.0F, spacingM - m_carriedM) / ahead;
            m_cursor->uv += (end.uv - m_cursor->uv) * fraction;
            m_cursor->pressure += (end.pressure - m_cursor->pressure) * fraction;
            m_last = sampleAtUv(m_cursor->uv, m_cursor->pressure);
            m_carriedM = 0.0F;
            onSample(m_last);
        }
        m_carriedM += m_last.metric.lengthM(end.uv - m_cursor->uv);
        m_cursor = end;
    }

    template<typename OnSample>
    void walkOnSkin(const ToolEvent& event, const OnSample& onSample)
    {
        const Cursor end = cursorOf(event);
        const Cursor begin = *m_cursor;
        const float lengthM = glm::length(end.positionHd - begin.positionHd);
        float along = m_spacingM - m_carriedM;
        while (along < lengthM) {
            const float fraction = along / lengthM;
            const glm::vec3 positionHd = begin.positionHd + (end.positionHd - begin.positionHd) * fraction;
            m_last = sampleAt(m_skin->nearest(positionHd), begin.pressure + (end.pressure - begin.pressure) * fraction);
            onSample(m_last); // May set the spacing.
            along += std::max(m_spacingM, kLeastWalkM);
        }
        m_last = sampleAt(*event.point, end.pressure);
        onSample(m_last);
        m_carriedM = 0.0F;
        m_cursor = end;
    }

    const sim::Skin* m_skin;
    float m_spacingM;
    float m_leastStepUv;
    std::optional<Cursor> m_cursor; ///< End of the path so far.
    BrushSample m_last;             ///< The last dab's sample; its metric is the average at first.
    float m_carriedM = 0.0F;        ///< Distance covered since the last sample.
};

} // namespace hairpaint::model
