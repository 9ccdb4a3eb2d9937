// The list of built-in heads.
#include "model/heads/built_in_heads.h"

#include <algorithm>
#include <array>

namespace hairpaint::heads {

std::span<const HeadRow* const> headRows()
{
    static const std::array heads = {&bust2(), &bust1()};
    return heads;
}

const HeadRow* findHeadRow(std::string_view name)
{
    const std::span<const HeadRow* const> heads = headRows();
    const auto found = std::ranges::find(heads, name, &HeadRow::name);
    return found != heads.end() ? *found : nullptr;
}

} // namespace hairpaint::heads
