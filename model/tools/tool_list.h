// One maker a tool; makeTools() calls them in tool-bar order.
#pragma once

#include "model/tools/tool.h"

namespace hairpaint::model {

[[nodiscard]] std::unique_ptr<Tool> makeBrushTool();
[[nodiscard]] std::unique_ptr<Tool> makeEraserTool();
[[nodiscard]] std::unique_ptr<Tool> makeCombTool();
[[nodiscard]] std::unique_ptr<Tool> makePartTool();
[[nodiscard]] std::unique_ptr<Tool> makeGrabTool();
[[nodiscard]] std::unique_ptr<Tool> makeGradientTool();
[[nodiscard]] std::unique_ptr<Tool> makeFillTool();
[[nodiscard]] std::unique_ptr<Tool> makeShapeTool();
[[nodiscard]] std::unique_ptr<Tool> makeSelectTool();
[[nodiscard]] std::unique_ptr<Tool> makePickerTool();

} // namespace hairpaint::model
