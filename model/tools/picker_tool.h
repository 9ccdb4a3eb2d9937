// Picking the value under the pointer, for the picker and for Ctrl+click with any tool.
#pragma once

#include "model/tools/tool.h"

namespace hairpaint::model {

/// Makes the resolved value under the pointer the one that its map is painted with.
void pickValue(const ToolEvent& event, ToolContext& context);

/// Where Ctrl is held, picks and returns true: the tool does nothing else with the press.
[[nodiscard]] bool picksInstead(const ToolEvent& event, ToolContext& context);

} // namespace hairpaint::model
