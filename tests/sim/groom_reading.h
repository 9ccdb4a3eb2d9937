// Single hairs out of a groom's chunks.
#pragma once

#include "sim/groom/groom.h"

namespace hairpaint::test {

using namespace hairpaint::sim;

inline const StrandStyle* styleAt(const Groom& groom, std::uint32_t slot)
{
    const auto& chunk = groom.chunks[slot / kChunkSlots];
    return chunk && chunk->hairs[slot % kChunkSlots] ? &chunk->styles[slot % kChunkSlots] : nullptr;
}

inline glm::vec3 restNode(const Groom& groom, std::uint32_t slot, int node)
{
    const StrandChunk& chunk = *groom.chunks[slot / kChunkSlots];
    const std::size_t local = slot % kChunkSlots;
    const float* at =
        chunk.restPositions.data() +
        (local / kLanes * static_cast<std::size_t>(groom.nodes) + static_cast<std::size_t>(node)) * 3 * kLanes +
        local % kLanes;
    return {at[0], at[kLanes], at[2 * kLanes]};
}

template<typename Visit>
void forEachHair(const Groom& groom, const Visit& visit)
{
    for (std::uint32_t slot = 0; slot < groom.roots->count(); ++slot)
        if (const StrandStyle* style = styleAt(groom, slot))
            visit(slot, *style);
}

} // namespace hairpaint::test
