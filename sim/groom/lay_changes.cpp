// The hairs near the cells that differ, then those that really pass there.
#include "sim/groom/lay_changes.h"

#include "sim/base/parallel.h"
#include "sim/groom/strand_style.h"

#include <limits>

namespace hairpaint::sim {

namespace {

/// Around the cells that differ, with as much room as a step of the lay may leave its nodes' box by.
PathBox boxOf(const LayField::Difference& difference)
{
    constexpr float kMarginM = 0.01F;
    PathBox box;
    for (const LayField::Cell& cell : difference.cells)
        box.include(cell.positionHd);
    box.leastHd -= SkinBand::kReachM + kMarginM;
    box.greatestHd += SkinBand::kReachM + kMarginM;
    return box;
}

} // namespace

void findRelaid(const LaidBefore& before, const LayField& field, const LayField::Difference& difference,
                ChangedSlots& changed)
{
    if (difference.indices.empty())
        return;
    std::vector<std::uint8_t> marked(field.cellCount(), 0);
    for (const std::uint32_t index : difference.indices)
        marked[index] = 1;
    const PathBox box = boxOf(difference);
    const Groom& groom = before.groom;
    const RootSet& roots = *groom.roots;
    const auto nodes = static_cast<std::size_t>(groom.nodes);
    const auto crosses = [&](std::uint32_t slot, float lengthM) {
        const RootChance chance = chanceOf(roots.seed, roots.rankOfSlot[slot]);
        return before.lay.crosses(layRootOf(roots, slot, chance), lengthM, nodes, marked);
    };
    parallelFor(groom.chunks.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t index = begin; index < end; ++index) {
            const StrandChunk* chunk = groom.chunks[index].get();
            if (chunk == nullptr)
                continue;
            for (std::size_t local = 0; local < kChunkSlots; ++local) {
                const auto slot = static_cast<std::uint32_t>(index * kChunkSlots + local);
                if (!chunk->hairs[local] || !chunk->pathBoxes[local].meets(box) || changed.hairs.contains(slot))
                    continue;
                const float lengthM = chunk->styles[local].lengthM;
                const std::uint32_t basis = roots.basisSlot[roots.neighbours[slot][0]];
                if (crosses(slot, lengthM) ||
                    (basis != slot && before.clump.scalar(roots.uv[slot]) > 0.0F && crosses(basis, lengthM)))
                    changed.hairs.insert(slot);
            }
        }
    });
    for (std::size_t i = 0; i < roots.basisSlot.size(); ++i) {
        const std::uint32_t slot = roots.basisSlot[i];
        if (changed.basis.contains(slot))
            continue;
        PathBox path;
        for (std::size_t node = 0; node < nodes; ++node)
            path.include(groom.blocks().node(groom.basis->restPositions, i, node));
        if (path.meets(box) && crosses(slot, before.basisLengthM[i]))
            changed.basis.insert(slot);
    }
}

} // namespace hairpaint::sim
