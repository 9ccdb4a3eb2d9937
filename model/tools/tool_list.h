// The makers of the tools, one for each, and the tool bar that they fill.
#pragma once

#include "model/tools/tool.h"

#include <memory>
#include <vector>

namespace hairpaint::model {

[[nodiscard]] std::unique_ptr<Tool> makeBrushTool();
[[nodiscard]] std::unique_ptr<Tool> makeEraserTool();
[[nodiscard]] std::unique_ptr<Tool> makeCombTool();
[[nodiscard]] std::unique_ptr<Tool> makePartTool();
[[nodiscard]] std::unique_ptr<Tool> makeGrabTool();
[[nodiscard]] std::unique_ptr<Tool> makeFingersTool();
[[nodiscard]] std::unique_ptr<Tool> makeScissorsTool();
[[nodiscard]] std::unique_ptr<Tool> makeGradientTool();
[[nodiscard]] std::unique_ptr<Tool> makeFillTool();
[[nodiscard]] std::unique_ptr<Tool> makeShapeTool();
[[nodiscard]] std::unique_ptr<Tool> makeSelectTool();
[[nodiscard]] std::unique_ptr<Tool> makePickerTool();

/// Every tool, in tool-bar order. Another tool is a file with its class, and a line here and there.
[[nodiscard]] std::vector<std::unique_ptr<Tool>> makeTools();

} // namespace hairpaint::model
