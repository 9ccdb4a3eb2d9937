// A slider over a number of the tool settings.
#pragma once

#include "view/editing/editor_state.h"

#include <functional>

namespace hairpaint::view {

class BarSlider;

/// What the slider is moved to is `set` at once, so that brush and palettes have it; where the user takes it back, all
/// is as it was before. The owner shows the settings in the slider when they change.
void bindToolSettings(BarSlider& slider, EditorState& state,
                      std::function<void(model::ToolSettings& settings, double shown)> set);

} // namespace hairpaint::view
