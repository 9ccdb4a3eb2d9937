// The tools, a line each, in tool-bar order. Their ids, their makers and the tool bar all follow from these lines.
#pragma once

#include <cstdint>

/// `row(Name)` for each tool. Another one is a line here and its file, which defines makeNameTool().
// clang-format off
#define HAIRPAINT_TOOLS(row) \
    row(Brush)               \
    row(Eraser)              \
    row(Comb)                \
    row(Part)                \
    row(Grab)                \
    row(Fingers)             \
    row(Scissors)            \
    row(Gradient)            \
    row(Fill)                \
    row(Shape)               \
    row(Select)              \
    row(Picker)
// clang-format on

namespace hairpaint::model {

enum class ToolId : std::uint8_t
{
#define HAIRPAINT_TOOL_ID(name) name,
    HAIRPAINT_TOOLS(HAIRPAINT_TOOL_ID)
#undef HAIRPAINT_TOOL_ID
};

} // namespace hairpaint::model
