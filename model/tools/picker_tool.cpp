// The picker.
#include "model/tools/picker_tool.h"
#include "model/maps/texel_ops.h"
#include "model/tools/tool_list.h"

#include <array>

namespace hairpaint::model {

namespace {

constexpr std::array kPickerOptions{&kValueOption, &kTouchOption};

constexpr ToolTraits kPicker{.id = ToolId::Picker,
                             .name = "picker",
                             .title = QT_TRANSLATE_NOOP("Tool", "Picker"),
                             .purpose = QT_TRANSLATE_NOOP("Tool", "Takes a value from the map, to paint on with it."),
                             .hint = QT_TRANSLATE_NOOP("Tool", "Click to take the value under the pointer"),
                             .key = Qt::Key_I,
                             .options = kPickerOptions,
                             .paints = false,
                             .worksOnHair = [](const ToolSettings&) { return true; }};

class PickerTool : public Tool
{
    Q_DECLARE_TR_FUNCTIONS(Tool)
public:
    [[nodiscard]] const ToolTraits& traits() const override { return kPicker; }

    void press(const ToolEvent& event, ToolContext& context) override
    {
        m_active = true;
        pickValue(event, context);
    }
    void move(const ToolEvent& event, ToolContext& context) override
    {
        if (m_active)
            pickValue(event, context);
    }
    void release(const ToolEvent& event, ToolContext& context) override
    {
        move(event, context);
        m_active = false;
    }
    void cancel(ToolContext& /*context*/) override { m_active = false; }
    void commit(ToolContext& /*context*/) override { m_active = false; }
    [[nodiscard]] bool active() const override { return m_active; }

private:
    bool m_active = false;
};

} // namespace

void pickValue(const ToolEvent& event, ToolContext& context)
{
    const auto map = context.document.resolvedNow(context.target.group, context.target.map);
    const std::optional<sim::SurfacePoint>& point = event.hair ? event.hair->root : event.point;
    if (map == nullptr || (event.area == Area::Head && !point))
        return;
    const MapSpec& spec = mapSpec(context.target.map);
    PaintValue value = texelOps(spec).paintValue(map->sampleNearest(event.hair ? point->uv : event.uv));
    if (spec.texel == TexelKind::Index)
        value.index = static_cast<int>(spec.entryOf(value.index)); // A row's number is chosen by each stroke.
    context.settings.value(spec.kind) = value;
}

bool picksInstead(const ToolEvent& event, ToolContext& context)
{
    if (!event.modifiers.testFlag(Qt::ControlModifier))
        return false;
    pickValue(event, context);
    return true;
}

std::unique_ptr<Tool> makePickerTool()
{
    return std::make_unique<PickerTool>();
}

} // namespace hairpaint::model
