// Finds the detail that keeps the right number, and copies the chunks that lose hairs.
#include "sim/groom/even_subset.h"

#include <algorithm>
#include <tuple>

namespace hairpaint::sim {

namespace {

/// A drawn hair, in the order in which hairs appear.
struct HairInOrder
{
    float detail;
    std::uint32_t group;
    std::uint32_t rank;
    friend auto operator<=>(const HairInOrder& a, const HairInOrder& b)
    {
        return std::tie(a.detail, a.group, a.rank) <=> std::tie(b.detail, b.group, b.rank);
    }
};

/// Calls visit(slot in the groom, chunk, slot in the chunk) for each drawn hair.
template<typename Visit>
void forEachDrawn(const Groom& groom, const Visit& visit)
{
    if (!groom.visible || groom.roots == nullptr)
        return;
    for (std::size_t chunk = 0; chunk < groom.chunks.size(); ++chunk)
        for (std::size_t i = 0; groom.chunks[chunk] != nullptr && i < kChunkSlots; ++i)
            if (groom.chunks[chunk]->drawn[i])
                visit(static_cast<std::uint32_t>(chunk * kChunkSlots + i), chunk, i);
}

} // namespace

std::vector<std::shared_ptr<const Groom>> evenSubset(const std::vector<std::shared_ptr<const Groom>>& grooms,
                                                     std::size_t count)
{
    const auto candidateAt = [&](std::uint32_t group, std::uint32_t slot) {
        const Groom& groom = *grooms[group];
        const StrandChunk& chunk = *groom.chunks[slot / kChunkSlots];
        return HairInOrder{chunk.styles[slot % kChunkSlots].detail, group, groom.roots->rankOfSlot[slot]};
    };
    std::vector<HairInOrder> candidates;
    for (std::uint32_t group = 0; group < grooms.size(); ++group)
        forEachDrawn(*grooms[group], [&](std::uint32_t slot, std::size_t, std::size_t) {
            candidates.push_back(candidateAt(group, slot));
        });
    if (candidates.size() <= count)
        return grooms;
    const auto firstLeftOut = candidates.begin() + static_cast<std::ptrdiff_t>(count);
    std::nth_element(candidates.begin(), firstLeftOut, candidates.end());
    const HairInOrder end = *firstLeftOut;

    std::vector<std::shared_ptr<const Groom>> result;
    for (std::uint32_t group = 0; group < grooms.size(); ++group) {
        auto thinned = std::make_shared<Groom>(*grooms[group]);
        std::vector<std::shared_ptr<StrandChunk>> copies(thinned->chunks.size());
        forEachDrawn(*grooms[group], [&](std::uint32_t slot, std::size_t chunk, std::size_t i) {
            if (candidateAt(group, slot) < end)
                return;
            if (copies[chunk] == nullptr)
                thinned->chunks[chunk] = copies[chunk] = std::make_shared<StrandChunk>(*grooms[group]->chunks[chunk]);
            copies[chunk]->hairs.reset(i);
            copies[chunk]->drawn.reset(i);
            --thinned->hairCount;
            --thinned->drawnCount;
        });
        result.push_back(std::move(thinned));
    }
    return result;
}

} // namespace hairpaint::sim
