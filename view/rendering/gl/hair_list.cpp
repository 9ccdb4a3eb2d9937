// Sorts the drawn strands by the detail at which they appear.
#include "view/rendering/gl/hair_list.h"

#include "sim/groom/strand_curve.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hairpaint::rendering {

void HairList::index(ChunkPart& part, const std::shared_ptr<const sim::StrandChunk>& from,
                     const sim::CurlSettings* coils)
{
    part.entries.clear();
    part.begin.fill(0);
    if (!from)
        return;
    const sim::StrandChunk& chunk = *from;
    const auto stepOf = [](float detail) {
        return std::min(static_cast<std::size_t>(std::max(detail, 0.0F) * static_cast<float>(kSteps)), kSteps - 1);
    };
    for (std::size_t slot = 0; slot < sim::kChunkSlots; ++slot)
        if (chunk.drawn[slot])
            ++part.begin[stepOf(chunk.styles[slot].detail) + 1];
    for (std::size_t step = 0; step < kSteps; ++step)
        part.begin[step + 1] = static_cast<std::uint16_t>(part.begin[step + 1] + part.begin[step]);
    part.entries.resize(part.begin[kSteps]);
    std::array<std::uint16_t, kSteps + 1> next = part.begin;
    for (std::size_t slot = 0; slot < sim::kChunkSlots; ++slot) {
        if (!chunk.drawn[slot])
            continue;
        const sim::StrandStyle& style = chunk.styles[slot];
        part.entries[next[stepOf(style.detail)]++] = {
            .slot = static_cast<std::uint16_t>(slot),
            .curveSegments = static_cast<std::uint16_t>(sim::curveSegmentsOf(style, coils)),
            .hasTipStart = style.tipStart > 0.0F,
            .detail = style.detail};
    }
    part.chunk = from;
}

bool HairList::update(const std::shared_ptr<const sim::Groom>& groom, float detail, SegmentsWanted wanted)
{
    if (groom == m_groom && detail == m_detail && wanted == m_wanted)
        return false;
    // Where memory runs out in between, the next call must not take this for a list.
    const std::shared_ptr<const sim::Groom> before = std::exchange(m_groom, nullptr);
    if (groom != before) {
        m_parts.resize(groom->chunks.size());
        for (std::size_t i = 0; i < m_parts.size(); ++i)
            if (m_parts[i].chunk != groom->chunks[i]) {
                m_parts[i].chunk.reset();
                index(m_parts[i], groom->chunks[i], sim::coilsOf(groom->settings));
            }
    }
    m_strands.clear();
    m_batches.clear();
    m_segments = 0;
    std::uint32_t point = 0;
    StrandBatch batch{};
    const auto steps = static_cast<std::size_t>(
        std::clamp(std::ceil(detail * static_cast<float>(kSteps)), 0.0F, static_cast<float>(kSteps)));
    for (std::size_t step = 0; step < steps; ++step)
        for (std::size_t c = 0; c < m_parts.size(); ++c) {
            const ChunkPart& part = m_parts[c];
            const auto chunkBase = static_cast<std::uint32_t>(std::max(groom->packedChunk[c], 0)) * sim::kChunkSlots;
            for (std::size_t e = part.begin[step]; e < part.begin[step + 1]; ++e) {
                const IndexedStrand& entry = part.entries[e];
                if (!(entry.detail < detail))
                    continue;
                const int straight =
                    entry.hasTipStart ? std::max(wanted.ofStraightHair, kSegmentsOfDyedHair) : wanted.ofStraightHair;
                const int segments = std::max(entry.curveSegments * wanted.curlFactor, straight);
                const auto points = static_cast<std::uint32_t>(segments + 1);
                if (batch.pointCount + points > kBatchPoints) {
                    m_batches.push_back(batch);
                    batch = {
                        .firstStrand = static_cast<std::uint32_t>(m_strands.size()), .strandCount = 0, .pointCount = 0};
                }
                m_strands.push_back({.slot = chunkBase + entry.slot, .firstPoint = point});
                point += points;
                batch.pointCount += points;
                ++batch.strandCount;
                m_segments += static_cast<std::size_t>(segments);
            }
        }
    if (batch.strandCount > 0)
        m_batches.push_back(batch);
    m_strands.push_back({.slot = 0, .firstPoint = point});
    m_groom = groom;
    m_detail = detail;
    m_wanted = wanted;
    return true;
}

} // namespace hairpaint::rendering
