// Gathers the drawn strands.
#include "view/rendering/software/strand_list.h"

#include <algorithm>
#include <cstddef>

namespace hairpaint::rendering {

void StrandList::update(const std::shared_ptr<const sim::Groom>& groom, float detail)
{
    if (groom == m_groom && detail == m_detail)
        return;
    m_detail = -1.0F; // Where memory runs out in between, the next call must not take this for a list.
    m_groom = groom;
    m_slots.clear();
    m_slots.reserve(groom->drawnCount);
    for (std::size_t c = 0; c < groom->chunks.size(); ++c) {
        if (!groom->chunks[c] || groom->packedChunk[c] < 0)
            continue;
        const sim::StrandChunk& chunk = *groom->chunks[c];
        const auto first = static_cast<std::ptrdiff_t>(m_slots.size());
        for (std::size_t local = 0; local < sim::kChunkSlots; ++local)
            if (chunk.drawn[local] && chunk.styles[local].detail < detail)
                m_slots.push_back(static_cast<std::uint32_t>(c * sim::kChunkSlots + local));
        std::stable_sort(m_slots.begin() + first, m_slots.end(), [&](std::uint32_t a, std::uint32_t b) {
            return chunk.styles[a % sim::kChunkSlots].detail < chunk.styles[b % sim::kChunkSlots].detail;
        });
    }
    m_detail = detail;
}

} // namespace hairpaint::rendering
