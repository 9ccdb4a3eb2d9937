// From the eye on, until hair that is in front hides all that follows.
#include "view/picking/touched_blocks.h"

#include "sim/base/parallel.h"
#include "view/picking/block_kernel.h"

#include <algorithm>
#include <array>
#include <bit>
#include <compare>
#include <memory>
#include <utility>

namespace hairpaint::view {

namespace {

constexpr std::size_t kBlocksATask = 32;
constexpr std::size_t kTouchesATask = 1024; ///< Touches that a task has room for at first.
/// Blocks nearest to the eye that are searched first; then twice as many each time.
constexpr std::size_t kFirstBlocks = 128;
constexpr float kLeastCellPx = 2.0F;
constexpr float kCellsAcross = 16.0F;         ///< Cells across the brush.
constexpr std::uint32_t kFrontLanes = 0x1111; ///< One strand of four tells where the foremost hair is.
/// Distance from the brush within which hair in front is searched, too: a curl may reach in.
constexpr float kBesideBrushPx = 8.0F;

/// Adds the touches of a block, strand by strand, root first; without those whose curve lies deeper than `deepestM`.
void touchBlock(const PictureHair& picture, std::size_t index, const PictureBrush& brush, float deepestM,
                BlockAnswer& answer, std::vector<Touch>& touches, FrontHair& front)
{
    const HairBoxes& boxes = picture.boxes;
    BlockQuestion question = picture.questionOf(index);
    question.box = brush.box;
    question.deepestM = deepestM;
    for (std::size_t span = 0; span < boxes.spans; ++span) {
        const std::size_t box = index * boxes.spans + span;
        if (boxes.boxes[box].meets(brush.box) && boxes.nearestM[box] <= deepestM)
            question.spans |= 1U << span;
    }
    findTouches(picture.lens, question, brush, answer);
    if (answer.anyNear == 0)
        return;
    // Transposes bits: from a bit a lane for each node to a bit a node for each lane.
    std::array<std::uint32_t, kPickLanes> touching{};
    for (std::size_t n = 1; n < question.nodes; ++n)
        for (std::uint32_t lanes = answer.touching[n]; lanes != 0; lanes &= lanes - 1)
            touching[static_cast<std::size_t>(std::countr_zero(lanes))] |= 1U << n;
    const auto at = [&answer](std::size_t n, std::size_t lane) {
        const auto& rows = answer.seen[n];
        return glm::vec3(rows[lane], rows[kPickLanes + lane], rows[2 * kPickLanes + lane]);
    };
    for (std::size_t n = 1; n < question.nodes; ++n)
        for (std::uint32_t lanes = answer.near[n] & kFrontLanes; lanes != 0; lanes &= lanes - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
            front.add(at(n - 1, lane), at(n, lane));
        }
    const std::uint32_t firstSlot = boxes.blocks[index].firstSlot;
    for (std::size_t lane = 0; lane < kPickLanes; ++lane)
        for (std::uint32_t segments = touching[lane]; segments != 0; segments &= segments - 1) {
            const auto n = static_cast<std::size_t>(std::countr_zero(segments));
            const glm::vec3 from = at(n - 1, lane);
            const glm::vec3 to = at(n, lane);
            const float fraction = answer.fraction[n][lane];
            touches.push_back({.slot = firstSlot + static_cast<std::uint32_t>(lane),
                               .node = static_cast<std::uint32_t>(n),
                               .fraction = fraction,
                               .apartPx = answer.apartPx[n][lane],
                               .strayPx = answer.strayPx[n][lane],
                               .nearestM = std::min(from.z, to.z) - question.straysM[lane],
                               .seen = from + (to - from) * fraction});
        }
}

/// A block near the brush.
struct NearBlock
{
    float depthM; ///< Least depth of its hair near the brush.
    std::uint32_t index;
    friend auto operator<=>(const NearBlock&, const NearBlock&) = default; // NOLINT(modernize-use-nullptr)
};

std::vector<NearBlock> blocksNear(const HairBoxes& boxes, const PictureBox& box)
{
    std::vector<NearBlock> blocks;
    for (std::size_t i = 0; i < boxes.blocks.size(); ++i) {
        if (!boxes.wholes[i].meets(box))
            continue;
        float depthM = kNoLimitM;
        for (std::size_t span = i * boxes.spans; span < (i + 1) * boxes.spans; ++span)
            if (boxes.boxes[span].meets(box))
                depthM = std::min(depthM, boxes.nearestM[span]);
        if (depthM < kNoLimitM)
            blocks.push_back({.depthM = depthM, .index = static_cast<std::uint32_t>(i)});
    }
    return blocks;
}

} // namespace

TouchedBlocks::TouchedBlocks(const PictureHair& picture, const PictureBrush& brush)
    : m_front(brush.box.widened(kBesideBrushPx), std::max(kLeastCellPx, 2.0F * brush.radiusPx / kCellsAcross)),
      m_deepestM(kNoLimitM)
{
    std::vector<NearBlock> blocks = blocksNear(picture.boxes, brush.box);
    const FrontHair open = m_front;
    std::size_t some = kFirstBlocks;
    for (std::size_t begin = 0; begin < blocks.size(); some *= 2) {
        // The blocks that are nearest to the eye among the rest.
        const std::size_t end = std::min(begin + some, blocks.size());
        if (end < blocks.size())
            std::nth_element(blocks.begin() + static_cast<std::ptrdiff_t>(begin),
                             blocks.begin() + static_cast<std::ptrdiff_t>(end), blocks.end());
        const std::size_t first = m_parts.size();
        const std::size_t tasks = (end - begin + kBlocksATask - 1) / kBlocksATask;
        m_parts.resize(first + tasks, Part{.touches = {}, .runs = {}, .front = open});
        sim::parallelFor(tasks, 1, [&](std::size_t from, std::size_t to) {
            const auto answer = std::make_unique_for_overwrite<BlockAnswer>();
            for (std::size_t task = from; task < to; ++task) {
                Part& part = m_parts[first + task];
                part.touches.reserve(kTouchesATask);
                const std::size_t until = std::min(begin + (task + 1) * kBlocksATask, end);
                for (std::size_t i = begin + task * kBlocksATask; i < until; ++i) {
                    touchBlock(picture, blocks[i].index, brush, m_deepestM, *answer, part.touches, part.front);
                    part.runs.push_back({.block = blocks[i].index, .end = part.touches.size()});
                }
            }
        });
        for (std::size_t part = first; part < m_parts.size(); ++part)
            m_front.add(m_parts[part].front);
        m_deepestM = m_front.hidesFrom([&brush](glm::vec2 middle) {
            const glm::vec2 segment = brush.to - brush.from;
            return glm::distance(middle, brush.from + segment * fractionNear(middle, brush.from, brush.to)) <=
                   brush.radiusPx;
        });
        begin = end;
        const auto left = blocks.begin() + static_cast<std::ptrdiff_t>(begin);
        blocks.erase(
            std::remove_if(left, blocks.end(), [this](const NearBlock& one) { return one.depthM > m_deepestM; }),
            blocks.end());
    }
}

std::vector<std::span<const Touch>> TouchedBlocks::blocks() const
{
    std::vector<std::pair<std::uint32_t, std::span<const Touch>>> found;
    for (const Part& part : m_parts) {
        std::size_t begin = 0;
        for (const Part::Run& run : part.runs) {
            if (run.end > begin)
                found.emplace_back(run.block, std::span(part.touches).subspan(begin, run.end - begin));
            begin = run.end;
        }
    }
    std::ranges::sort(found, {}, [](const auto& one) { return one.first; });
    std::vector<std::span<const Touch>> blocks;
    blocks.reserve(found.size());
    for (const auto& [block, touches] : found)
        blocks.push_back(touches);
    return blocks;
}

} // namespace hairpaint::view
