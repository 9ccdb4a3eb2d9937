// A box from every node of every positioned block.
#include "view/picking/hair_boxes.h"

#include "sim/base/parallel.h"
#include "sim/groom/strand_curve.h"
#include "view/picking/block_kernel.h"

#include <algorithm>
#include <bit>

namespace hairpaint::view {

namespace {

constexpr std::size_t kBlocksAtOnce = 128;
// Greatest distance of drawn curves from the skeleton, over the radii in StrandStyle.
constexpr float kCurlReach = 1.2F;
constexpr float kCoilReach = 2.0F;
constexpr float kFrizzReach = 1.5F;
constexpr float kBraidReach = 2.5F;
constexpr float kSagOfSegment = 0.06F; ///< Distance of the spline from a segment's chord, over the segment's length.

std::uint32_t positionedLanes(const sim::GroupFrame& group, std::size_t firstSlot)
{
    std::uint32_t lanes = 0;
    for (std::size_t lane = 0; lane < kPickLanes; ++lane)
        lanes |= (group.isPositioned(firstSlot + lane) ? 1U : 0U) << lane;
    return lanes;
}

} // namespace

float strayM(const sim::Groom& groom, std::size_t slot)
{
    const sim::StrandStyle& style = groom.style(slot);
    const bool curls = style.turns > 0.0F && style.curlRadiusM > 0.0F;
    const float curl =
        curls ? style.curlRadiusM * (sim::coilsOf(groom.settings) != nullptr ? kCoilReach : kCurlReach) : 0.0F;
    const float braid = style.braid != sim::BraidKind::None ? style.braidRadiusM * kBraidReach : 0.0F;
    return std::max(curl, braid) + style.frizzM * kFrizzReach +
           style.lengthM / static_cast<float>(groom.nodes - 1) * kSagOfSegment;
}

HairBoxes::HairBoxes(const sim::GroupFrame& group, const Lens& lens)
{
    if (!group.groom || group.positions.empty())
        return;
    const sim::Groom& groom = *group.groom;
    const auto nodes = static_cast<std::size_t>(groom.nodes);
    for (std::size_t chunk = 0; chunk < groom.chunks.size(); ++chunk)
        if (groom.chunks[chunk] && groom.packedChunk[chunk] >= 0)
            for (std::size_t block = 0; block < sim::kBlocksPerChunk; ++block)
                if (groom.chunks[chunk]->leastDetail[block] < group.detail)
                    blocks.push_back(
                        {.firstSlot = static_cast<std::uint32_t>(chunk * sim::kChunkSlots + block * kPickLanes)});
    spans = (nodes - 1 + kSpan - 1) / kSpan;
    wholes.resize(blocks.size());
    boxes.resize(blocks.size() * spans);
    nearestM.resize(boxes.size());
    strays.resize(blocks.size() * kPickLanes);
    sim::parallelFor(blocks.size(), kBlocksAtOnce, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            Block& block = blocks[i];
            block.lanes = positionedLanes(group, block.firstSlot);
            float farthestM = 0.0F;
            for (std::uint32_t lanes = block.lanes; lanes != 0; lanes &= lanes - 1) {
                const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
                strays[i * kPickLanes + lane] = strayM(groom, block.firstSlot + lane);
                farthestM = std::max(farthestM, strays[i * kPickLanes + lane]);
            }
            BlockQuestion question;
            question.nodesWo = group.positions.data() + groom.blocks().index(groom.frameStrand(block.firstSlot), 0);
            question.nodes = nodes;
            question.lanes = block.lanes;
            findBoxes(lens, question, boxes.data() + i * spans, nearestM.data() + i * spans);
            const float leastM = *std::min_element(nearestM.data() + i * spans, nearestM.data() + (i + 1) * spans);
            for (std::size_t span = i * spans; span < (i + 1) * spans; ++span) {
                boxes[span] = boxes[span].widened(farthestM * lens.pxPerM(leastM));
                nearestM[span] -= farthestM;
                wholes[i].add(boxes[span]);
            }
        }
    });
}

} // namespace hairpaint::view
