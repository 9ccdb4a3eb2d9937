// Gathers the drawn strands in the order of their slots.
#include "view/rendering/software/strand_list.h"

#include <utility>

namespace hairpaint::rendering {

void StrandList::update(const std::shared_ptr<const sim::Groom>& groom, float detail)
{
    if (groom == m_groom && detail == m_detail)
        return;
    m_detail = -1.0F; // Where memory runs out half-way, the next call must not take this for a list.
    m_groom = groom;
    m_slots.clear();
    m_slots.reserve(groom->drawnCount);
    for (std::size_t c = 0; c < groom->chunks.size(); ++c) {
        if (!groom->chunks[c] || groom->packedChunk[c] < 0)
            continue;
        const sim::StrandChunk& chunk = *groom->chunks[c];
        for (std::size_t local = 0; local < sim::kChunkSlots; ++local)
            if (chunk.drawn[local] && chunk.styles[local].detail < detail)
                m_slots.push_back(static_cast<std::uint32_t>(c * sim::kChunkSlots + local));
    }
    m_detail = detail;
}

} // namespace hairpaint::rendering
