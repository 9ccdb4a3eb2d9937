// Hairs that were laid side by side, put where their chunk has them.
#pragma once

#include "sim/base/strand_blocks.h"

#include <algorithm>
#include <cstddef>
#include <span>

namespace hairpaint::sim {

/// Copies the first `count` lanes of `nodesHd` [nodes][3][kLanes] into `chunk`, blocks of such hairs: lane i to
/// `localOf(i)`, its number in the chunk, which rises from lane to lane.
template<typename LocalOf>
void storeLanes(const StrandBlocks& blocks, std::span<const float> nodesHd, std::size_t count, const LocalOf& localOf,
                std::span<float> chunk)
{
    const auto at = [&](std::size_t lane) { return chunk.data() + blocks.index(localOf(lane), 0); };
    // All of a block, in its order.
    if (count == kLanes && localOf(0) % kLanes == 0 && localOf(count - 1) - localOf(0) == kLanes - 1) {
        std::ranges::copy(nodesHd.first(blocks.blockFloats()), at(0));
        return;
    }
    for (std::size_t lane = 0; lane < count; ++lane) {
        float* const to = at(lane);
        for (std::size_t row = 0; row < blocks.blockFloats(); row += kLanes)
            to[row] = nodesHd[row + lane];
    }
}

} // namespace hairpaint::sim
