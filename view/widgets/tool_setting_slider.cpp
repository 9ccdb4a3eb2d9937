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
    const auto before = std::make_shared<std::optional<EditorState::HeldSettings>>();
    QObject::connect(&slider, &BarSlider::editingBegan, &state, [before, &state] { *before = state.heldSettings(); });
    QObject::connect(&slider, &BarSlider::valueChanged, &state, [&state, set = std::move(set)](double shown) {
        model::ToolSettings settings = state.toolSettings();
        set(settings, shown);
        state.setToolSettings(settings);
    });
    QObject::connect(&slider, &BarSlider::editingFinished, &state, [before] { before->reset(); });
    QObject::connect(&slider, &BarSlider::editingCancelled, &state, [before, &state] {
        if (const auto held = std::exchange(*before, std::nullopt))
            state.putBack(*held);
    });
}

} // namespace hairpaint::view
