// An even fraction of the hairs that are there, for files and pictures with fewer of them.
#pragma once

#include "sim/groom/groom.h"

#include <memory>
#include <vector>

namespace hairpaint::sim {

/// The grooms with the `count` of their drawn hairs that appear first as detail rises, over all visible groups
/// together: everywhere the same fraction of what is painted there, and every smaller fraction is part of a larger one.
/// With `count` or fewer drawn hairs the grooms themselves. Chunks of which every hair stays are shared.
[[nodiscard]] std::vector<std::shared_ptr<const Groom>>
evenSubset(const std::vector<std::shared_ptr<const Groom>>& grooms, std::size_t count);

} // namespace hairpaint::sim
