// The tools, in tool-bar order.
#include "model/tools/tool_list.h"

namespace hairpaint::model {

std::vector<std::unique_ptr<Tool>> makeTools()
{
    std::vector<std::unique_ptr<Tool>> tools;
#define HAIRPAINT_ADD_TOOL(name) tools.push_back(make##name##Tool());
    HAIRPAINT_TOOLS(HAIRPAINT_ADD_TOOL)
#undef HAIRPAINT_ADD_TOOL
    return tools;
}

} // namespace hairpaint::model
