// Rectangle selection.
#include "model/tools/picker_tool.h"
#include "model/tools/strokes/selection.h"
#include "model/tools/tool_list.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::model {

namespace {

constexpr double kSmallestUv = 0.002; ///< Less is a click, which selects nothing.

constexpr ToolTraits kSelect{
    .id = ToolId::Select,
    .name = "select",
    .title = QT_TRANSLATE_NOOP("Tool", "Select"),
    .purpose = QT_TRANSLATE_NOOP("Tool", "Limits what is painted to a rectangle."),
    .hint = QT_TRANSLATE_NOOP(
        "Tool", "Drag a rectangle, Shift adds to the selection or makes a square; click to select nothing"),
    .key = Qt::Key_M,
    .paints = false,
    .selects = true};

class SelectTool : public Tool
{
    Q_DECLARE_TR_FUNCTIONS(Tool)
public:
    [[nodiscard]] const ToolTraits& traits() const override { return kSelect; }

    void press(const ToolEvent& event, ToolContext& context) override
    {
        if (picksInstead(event, context) || m_active || (event.area == Area::Head && !event.point))
            return;
        m_active = true;
        m_before = context.selection.rectangles();
        m_adds = event.modifiers.testFlag(Qt::ShiftModifier) && !m_before.empty();
        m_startUv = event.uv;
    }
    void move(const ToolEvent& event, ToolContext& context) override
    {
        if (!m_active || (event.area == Area::Head && !event.point))
            return;
        const std::optional<QRectF> rectangle = rectangleTo(event);
        std::vector<QRectF> all;
        if (m_adds)
            all = rectangle ? without(m_before, *rectangle) : m_before;
        if (rectangle)
            all.push_back(*rectangle);
        context.selection.setRectangles(std::move(all));
    }
    void release(const ToolEvent& event, ToolContext& context) override
    {
        move(event, context);
        m_active = false;
    }
    void cancel(ToolContext& context) override
    {
        if (m_active)
            context.selection.setRectangles(m_before);
        m_active = false;
    }
    void commit(ToolContext& /*context*/) override { m_active = false; }
    [[nodiscard]] bool active() const override { return m_active; }

private:
    [[nodiscard]] std::optional<QRectF> rectangleTo(const ToolEvent& event) const
    {
        glm::vec2 extent = event.uv - m_startUv;
        if (!m_adds && event.modifiers.testFlag(Qt::ShiftModifier)) {
            const float side = std::max(std::abs(extent.x), std::abs(extent.y));
            extent = {std::copysign(side, extent.x), std::copysign(side, extent.y)};
        }
        const QRectF whole(0.0, 0.0, 1.0, 1.0);
        const QRectF rectangle = QRectF(m_startUv.x, m_startUv.y, extent.x, extent.y).normalized().intersected(whole);
        if (rectangle.width() < kSmallestUv || rectangle.height() < kSmallestUv)
            return std::nullopt;
        return rectangle;
    }

    bool m_active = false;
    bool m_adds = false; ///< Shift was down where the drag began.
    std::vector<QRectF> m_before;
    glm::vec2 m_startUv{0.0F};
};

} // namespace

std::unique_ptr<Tool> makeSelectTool()
{
    return std::make_unique<SelectTool>();
}

} // namespace hairpaint::model
