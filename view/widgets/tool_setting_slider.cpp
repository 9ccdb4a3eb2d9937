// Tool settings set and put back.
#include "view/widgets/tool_setting_slider.h"

#include "view/widgets/bar_slider.h"

#include <memory>
#include <optional>
#include <utility>

namespace hairpaint::view {

void bindToolSettings(BarSlider& slider, EditorState& state,
                      std::function<void(model::ToolSettings& settings, double shown)> set)
{
    const auto before = std::make_shared<std::optional<ToolBox::HeldSettings>>();
    QObject::connect(&slider, &BarSlider::editingBegan, &state,
                     [before, &state] { *before = state.tools().heldSettings(); });
    QObject::connect(&slider, &BarSlider::valueChanged, &state, [&state, set = std::move(set)](double shown) {
        model::ToolSettings settings = state.tools().settings();
        set(settings, shown);
        state.tools().setSettings(settings);
    });
    QObject::connect(&slider, &BarSlider::editingFinished, &state, [before] { before->reset(); });
    QObject::connect(&slider, &BarSlider::editingCancelled, &state, [before, &state] {
        if (const auto held = std::exchange(*before, std::nullopt))
            state.tools().putBack(*held);
    });
}

} // namespace hairpaint::view
