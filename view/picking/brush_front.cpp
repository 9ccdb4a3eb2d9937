// From the eye on, until hair that is in front hides all that follows.
#include "view/picking/brush_front.h"

#include "sim/base/parallel.h"
#include "view/picking/block_kernel.h"
#include "view/picking/picture_hair.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <memory>

namespace hairpaint::view {

namespace {

constexpr std::size_t kFrontBlocksATask = 16;
/// The foremost hair is told by about so many blocks, or by one of kFrontOneOf where that is fewer.
constexpr std::size_t kFrontBlocks = 128;
constexpr std::size_t kFrontOneOf = 4;
/// Blocks nearest to the eye that are searched first; then twice as many each time.
constexpr std::size_t kFirstBlocks = 32;
constexpr float kLeastCellPx = 2.0F;
constexpr float kCellsAcross = 16.0F; ///< Cells across the brush.
/// Distance from the brush within which hair in front is searched, too: a curl may reach in.
constexpr float kBesideBrushPx = 8.0F;

std::vector<NearBlock> blocksNear(const HairBoxes& boxes, const PictureBox& box)
{
    constexpr std::size_t kBlocksATask = 1024;
    std::vector<std::vector<NearBlock>> near((boxes.blocks.size() + kBlocksATask - 1) / kBlocksATask);
    sim::parallelFor(near.size(), 1, [&](std::size_t begin, std::size_t end) {
        const std::size_t until = std::min(end * kBlocksATask, boxes.blocks.size());
        for (std::size_t i = begin * kBlocksATask; i < until; ++i) {
            if (!boxes.wholes[i].meets(box))
                continue;
            NearBlock block{.depthM = kNoLimitM, .index = static_cast<std::uint32_t>(i), .spans = 0};
            for (std::size_t span = 0; span < boxes.spans; ++span) {
                const std::size_t at = i * boxes.spans + span;
                if (!boxes.boxes[at].meets(box))
                    continue;
                block.depthM = std::min(block.depthM, boxes.nearestM[at]);
                block.spans |= 1U << span;
            }
            if (block.depthM < kNoLimitM)
                near[i / kBlocksATask].push_back(block);
        }
    });
    return joined(near);
}

void addBlock(const PictureHair& picture, const BlockQuestion& question, BlockAnswer& answer, FrontHair& front)
{
    if (question.spans == 0)
        return;
    findNear(picture.lens, question, answer);
    if (answer.anyNear == 0)
        return;
    const auto at = [&answer](std::size_t n, std::size_t lane) {
        const auto& rows = answer.seen[n];
        return glm::vec3(rows[lane], rows[kPickLanes + lane], rows[2 * kPickLanes + lane]);
    };
    for (std::size_t n = 1; n < question.nodes; ++n)
        for (std::uint32_t lanes = answer.near[n]; lanes != 0; lanes &= lanes - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
            front.add(at(n - 1, lane), at(n, lane));
        }
}

} // namespace

BlockQuestion BrushFront::questionOf(const NearBlock& block) const
{
    const HairBoxes& boxes = m_picture.boxes;
    BlockQuestion question = m_picture.questionOf(block.index);
    question.box = m_brush.box;
    question.deepestM = m_deepestM;
    for (std::uint32_t left = block.spans; left != 0; left &= left - 1) {
        const auto span = static_cast<std::size_t>(std::countr_zero(left));
        const std::size_t box = block.index * boxes.spans + span;
        if (boxes.nearestM[box] <= m_deepestM && !m_front.hidesAll(boxes.boxes[box], boxes.nearestM[box]))
            question.spans |= 1U << span;
    }
    return question;
}

BrushFront::BrushFront(const PictureHair& picture, const PictureBrush& brush)
    : m_picture(picture), m_brush(brush),
      m_front(brush.box.widened(kBesideBrushPx), std::max(kLeastCellPx, 2.0F * brush.radiusPx / kCellsAcross)),
      m_deepestM(kNoLimitM)
{
    const std::vector<NearBlock> near = blocksNear(picture.boxes, brush.box);
    std::vector<NearBlock> some;
    const std::size_t step = std::max(kFrontOneOf, near.size() / kFrontBlocks);
    some.reserve(near.size() / step + 1);
    for (std::size_t i = 0; i < near.size(); i += step)
        some.push_back(near[i]);
    std::ranges::sort(some);
    const FrontHair open = m_front;
    std::size_t count = kFirstBlocks;
    for (std::size_t begin = 0; begin < some.size() && some[begin].depthM <= m_deepestM; count *= 2) {
        const std::size_t end = std::min(begin + count, some.size());
        std::vector<FrontHair> fronts((end - begin + kFrontBlocksATask - 1) / kFrontBlocksATask, open);
        sim::parallelFor(fronts.size(), 1, [&](std::size_t from, std::size_t to) {
            const auto answer = std::make_unique_for_overwrite<BlockAnswer>();
            for (std::size_t task = from; task < to; ++task) {
                const std::size_t until = std::min(begin + (task + 1) * kFrontBlocksATask, end);
                for (std::size_t i = begin + task * kFrontBlocksATask; i < until; ++i)
                    addBlock(picture, questionOf(some[i]), *answer, fronts[task]);
            }
        });
        for (const FrontHair& front : fronts)
            m_front.add(front);
        m_deepestM = m_front.hidesFrom([&brush](glm::vec2 middle) {
            const glm::vec2 segment = brush.to - brush.from;
            return glm::distance(middle, brush.from + segment * fractionNear(middle, brush.from, brush.to)) <=
                   brush.radiusPx;
        });
        begin = end;
    }
    m_blocks.reserve(near.size());
    for (const NearBlock& block : near)
        if (block.depthM <= m_deepestM)
            m_blocks.push_back(block);
}

} // namespace hairpaint::view
