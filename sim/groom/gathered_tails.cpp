// Nodes from the ring on, chunk by chunk.
#include "sim/groom/gathered_tails.h"

#include "sim/base/parallel.h"
#include "sim/groom/gathered_path.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace hairpaint::sim {

namespace {

/// Null where none has a tail.
std::shared_ptr<const StrandChunk> chunkOfTails(const StrandChunk& chunk, int nodes)
{
    if ((chunk.tailed & chunk.drawn).none())
        return nullptr;
    const auto ring = static_cast<std::size_t>(ringNode(nodes));
    const std::size_t rows = static_cast<std::size_t>(nodes) - ring;
    auto tails = std::make_shared<StrandChunk>();
    tails->hairs = tails->drawn = chunk.tailed & chunk.drawn;
    tails->styles.resize(kChunkSlots);
    tails->clump.assign(kChunkSlots, 0.0F);
    tails->followed.resize(kChunkSlots);
    tails->braidCentre.assign(kChunkSlots, kNoCentre);
    tails->segmentLengths.assign(kChunkSlots, 0.0F);
    const StrandBlocks whole(nodes);
    const StrandBlocks behind(static_cast<int>(rows));
    tails->restPositions.assign(behind.floatsFor(kBlocksPerChunk), 0.0F);
    tails->leastDetail.fill(StrandStyle{}.detail);
    for (std::size_t slot = 0; slot < kChunkSlots; ++slot) {
        if (!tails->hairs[slot])
            continue;
        tails->styles[slot] = chunk.styles[slot];
        tails->clump[slot] = chunk.clump[slot];
        tails->followed[slot] = chunk.followed[slot];
        for (std::size_t row = 0; row < rows; ++row)
            behind.setNode(tails->restPositions, slot, row, whole.node(chunk.restPositions, slot, ring + row));
        const glm::vec3 first =
            whole.node(chunk.restPositions, slot, ring + 1) - whole.node(chunk.restPositions, slot, ring);
        tails->segmentLengths[slot] = std::sqrt(glm::dot(first, first));
        float& least = tails->leastDetail[slot / kLanes];
        least = std::min(least, chunk.styles[slot].detail);
    }
    return tails;
}

} // namespace

std::shared_ptr<const Groom> tailsOf(const Groom& groom, const std::shared_ptr<const BasisStyles>& basis,
                                     const Groom* before)
{
    const Groom* known = before != nullptr && before->roots == groom.roots && before->nodes == groom.nodes
                             ? before->tails.get()
                             : nullptr;
    auto tails = std::make_shared<Groom>();
    tails->groupId = groom.groupId;
    tails->visible = groom.visible;
    tails->settings = groom.settings;
    tails->nodes = groom.nodes - ringNode(groom.nodes);
    tails->settings.nodesPerHair = tails->nodes;
    tails->roots = groom.roots;
    tails->isOfTails = true;
    tails->basis = basis;
    tails->chunks.resize(groom.chunks.size());
    tails->packedChunk.assign(groom.chunks.size(), -1);
    bool isSame = known != nullptr && known->basis == basis && known->visible == tails->visible &&
                  known->settings == tails->settings;
    parallelFor(groom.chunks.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const std::shared_ptr<const StrandChunk>& chunk = groom.chunks[i];
            if (known != nullptr && before->chunks[i] == chunk)
                tails->chunks[i] = known->chunks[i];
            else if (chunk && chunk->tailed.any())
                tails->chunks[i] = chunkOfTails(*chunk, groom.nodes);
        }
    });
    for (std::size_t i = 0; i < tails->chunks.size(); ++i) {
        isSame = isSame && tails->chunks[i] == known->chunks[i];
        if (!tails->chunks[i])
            continue;
        tails->packedChunk[i] = tails->packedChunks++;
        tails->hairCount += tails->chunks[i]->hairs.count();
    }
    if (tails->packedChunks == 0)
        return nullptr;
    tails->drawnCount = tails->hairCount;
    for (const std::uint32_t lanes : basis->wanted)
        tails->basisCount += static_cast<std::size_t>(std::popcount(lanes));
    if (isSame)
        return before->tails;
    return tails;
}

} // namespace hairpaint::sim
