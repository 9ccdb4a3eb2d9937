// The makers of the tools, one for each, and the tool bar that they fill.
#pragma once

#include "model/tools/tool.h"

#include <memory>
#include <vector>

namespace hairpaint::model {

#define HAIRPAINT_TOOL_MAKER(name) [[nodiscard]] std::unique_ptr<Tool> make##name##Tool();
HAIRPAINT_TOOLS(HAIRPAINT_TOOL_MAKER)
#undef HAIRPAINT_TOOL_MAKER

/// Every tool, in tool-bar order.
[[nodiscard]] std::vector<std::unique_ptr<Tool>> makeTools();
/// Their rows, each once.
[[nodiscard]] ToolOptions toolOptions();

} // namespace hairpaint::model
