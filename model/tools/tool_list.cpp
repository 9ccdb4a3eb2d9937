// The tools, in tool-bar order.
#include "model/tools/tool_list.h"

#include <algorithm>

namespace hairpaint::model {

std::vector<std::unique_ptr<Tool>> makeTools()
{
    std::vector<std::unique_ptr<Tool>> tools;
#define HAIRPAINT_ADD_TOOL(name) tools.push_back(make##name##Tool());
    HAIRPAINT_TOOLS(HAIRPAINT_ADD_TOOL)
#undef HAIRPAINT_ADD_TOOL
    return tools;
}

ToolOptions toolOptions()
{
    // The rows last as long as the program; the tools are made only to name theirs.
    static const std::vector<const ToolOption*> all = [] {
        std::vector<const ToolOption*> rows;
        for (const std::unique_ptr<Tool>& tool : makeTools())
            for (const ToolOption* row : tool->options())
                if (std::ranges::find(rows, row) == rows.end())
                    rows.push_back(row);
        return rows;
    }();
    return all;
}

} // namespace hairpaint::model
