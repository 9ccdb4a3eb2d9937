// Single hairs out of a groom's chunks.
#pragma once

#include "sim/groom/groom.h"

namespace hairpaint::test {

using namespace hairpaint::sim;

inline const StrandStyle* styleAt(const Groom& groom, std::uint32_t slot)
{
    const auto& chunk = groom.chunks[chunkOf(slot)];
    return chunk && chunk->hairs[inChunk(slot)] ? &chunk->styles[inChunk(slot)] : nullptr;
}

inline glm::vec3 restNode(const Groom& groom, std::uint32_t slot, int node)
{
    return groom.blocks().node(groom.chunks[chunkOf(slot)]->restPositions, inChunk(slot),
                               static_cast<std::size_t>(node));
}

template<typename Visit>
void forEachHair(const Groom& groom, const Visit& visit)
{
    for (std::uint32_t slot = 0; slot < groom.roots->count(); ++slot)
        if (const StrandStyle* style = styleAt(groom, slot))
            visit(slot, *style);
}

} // namespace hairpaint::test
