// The list of built-in heads.
#include "model/heads/built_in_heads.h"

#include <algorithm>
#include <array>

namespace hairpaint::heads {

std::span<const BuiltInHead* const> builtInHeads()
{
    static const std::array heads = {&bust2(), &bust1()};
    return heads;
}

const BuiltInHead* findBuiltInHead(std::string_view name)
{
    const std::span<const BuiltInHead* const> heads = builtInHeads();
    const auto found = std::ranges::find(heads, name, &BuiltInHead::name);
    return found != heads.end() ? *found : nullptr;
}

} // namespace hairpaint::heads
