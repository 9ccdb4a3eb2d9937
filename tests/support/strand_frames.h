// Reading single strands out of frames.
#pragma once

#include "sim/motion/simulation.h"

#include <vector>

namespace hairpaint::test {

inline sim::StrandFrame frameOf(const sim::Simulation& simulation)
{
    sim::StrandFrame frame;
    simulation.writeFrame(frame);
    return frame;
}

/// A slot's nodes in the first group; empty where it is not drawn.
inline std::vector<glm::vec3> nodesOf(const sim::StrandFrame& frame, std::size_t slot)
{
    const sim::Groom& groom = *frame.groups.front().groom;
    const std::int32_t place = groom.chunkPlace[slot / sim::kChunkSlots];
    if (place < 0 || !groom.chunks[slot / sim::kChunkSlots]->drawn[slot % sim::kChunkSlots])
        return {};
    const auto nodes = static_cast<std::size_t>(groom.nodes);
    const std::size_t block =
        static_cast<std::size_t>(place) * sim::kBlocksPerChunk + slot % sim::kChunkSlots / sim::kLanes;
    std::vector<glm::vec3> result;
    for (std::size_t node = 0; node < nodes; ++node) {
        const float* at =
            frame.groups.front().positions.data() + (block * nodes + node) * 3 * sim::kLanes + slot % sim::kLanes;
        result.emplace_back(at[0], at[sim::kLanes], at[2 * sim::kLanes]);
    }
    return result;
}

} // namespace hairpaint::test
