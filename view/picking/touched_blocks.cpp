// From the eye on, until hair that is in front hides all that follows.
#include "view/picking/touched_blocks.h"

#include "sim/base/parallel.h"

#include <algorithm>
#include <array>
#include <bit>
#include <compare>
#include <utility>

namespace hairpaint::view {

namespace {

constexpr std::size_t kBlocksATask = 32;
constexpr std::size_t kFirstBlocks = 128; ///< Of those nearest to the eye; then twice as many each time.
constexpr float kLeastCellPx = 2.0F;
constexpr float kCellsAcross = 16.0F;   ///< The brush.
constexpr std::size_t kLanesAFront = 4; ///< One strand of so many tells where the foremost hair is.
constexpr float kBesideBrushPx = 8.0F;  ///< Hair so near to it is looked at, too: a curl may reach in.

/// By strands, root first. What is drawn deeper than `deepestM` is passed over.
void touchBlock(const PictureHair& picture, std::size_t index, const PictureBrush& brush, float deepestM,
                std::vector<Touch>& touches, FrontHair& front)
{
    const HairBoxes::Block& block = picture.boxes.blocks[index];
    const sim::Groom& groom = *picture.hair->groom;
    const auto nodes = static_cast<std::size_t>(groom.nodes);
    const float* node = picture.hair->positions.data() + groom.blocks().index(groom.frameStrand(block.firstSlot), 0);
    constexpr std::uint32_t kAllLanes = (1U << kPickLanes) - 1U;
    std::array<bool, sim::kMostNodes> spanMeets{};
    std::array<std::array<float, 3 * kPickLanes>, sim::kMostNodes> seen; // Written where read.
    float nearestM = 1e9F;
    for (std::size_t span = 0; span < picture.boxes.spans; ++span) {
        const std::size_t box = index * picture.boxes.spans + span;
        const bool meets = picture.boxes.boxes[box].meets(brush.box) && picture.boxes.nearestM[box] <= deepestM;
        spanMeets[span] = meets;
        const std::size_t first = span * HairBoxes::kSpan;
        for (std::size_t n = first; meets && n <= std::min(first + HairBoxes::kSpan, nodes - 1); ++n) {
            picture.lens.seen(node + n * sim::StrandBlocks::kNodeStride, seen[n].data());
            const float* depths = seen[n].data() + 2 * kPickLanes;
            if (block.lanes == kAllLanes)
                for (std::size_t lane = 0; lane < kPickLanes; ++lane)
                    nearestM = std::min(nearestM, depths[lane]);
            else
                for (std::uint32_t lanes = block.lanes; lanes != 0; lanes &= lanes - 1)
                    nearestM = std::min(nearestM, depths[static_cast<std::size_t>(std::countr_zero(lanes))]);
        }
    }
    const float* strays = picture.boxes.strays.data() + index * kPickLanes;
    // Of the brush, with room for the curls of the block.
    const float strayM = *std::max_element(strays, strays + kPickLanes);
    const PictureBox near = brush.box.widened(strayM * picture.lens.pxPerM(nearestM));
    std::array<std::uint32_t, sim::kMostNodes> meeting{};
    std::uint32_t anywhere = 0;
    for (std::size_t n = 1; n < nodes; ++n)
        if (spanMeets[(n - 1) / HairBoxes::kSpan])
            anywhere |= meeting[n] =
                block.lanes & lanesMeeting(seen[n - 1].data(), seen[n].data(), near, deepestM + strayM);
    for (std::uint32_t lanes = anywhere; lanes != 0; lanes &= lanes - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
        const auto slot = static_cast<std::uint32_t>(block.firstSlot + lane);
        const auto at = [&](std::size_t n) {
            return glm::vec3(seen[n][lane], seen[n][kPickLanes + lane], seen[n][2 * kPickLanes + lane]);
        };
        for (std::size_t n = 1; n < nodes; ++n) {
            if ((meeting[n] >> lane & 1U) == 0)
                continue;
            const glm::vec3 from = at(n - 1);
            const glm::vec3 to = at(n);
            const float strayPx = strays[lane] * picture.lens.pxPerM(std::min(from.z, to.z));
            if (lane % kLanesAFront == 0)
                front.add(from, to);
            const Nearest nearest = nearestOf(glm::vec2(from), glm::vec2(to), brush.from, brush.to);
            if (nearest.apart <= brush.radiusPx + strayPx)
                touches.push_back({.slot = slot,
                                   .node = static_cast<std::uint32_t>(n),
                                   .fraction = nearest.fraction,
                                   .apartPx = nearest.apart,
                                   .strayPx = strayPx,
                                   .nearestM = std::min(from.z, to.z) - strays[lane],
                                   .seen = from + (to - from) * nearest.fraction});
        }
    }
}

/// A block near the brush.
struct NearBlock
{
    float depthM; ///< Before which nothing of it is drawn near the brush.
    std::uint32_t index;
    friend auto operator<=>(const NearBlock&, const NearBlock&) = default; // NOLINT(modernize-use-nullptr)
};

/// Those nearest to the eye first.
std::vector<NearBlock> blocksNear(const HairBoxes& boxes, const PictureBox& box)
{
    std::vector<NearBlock> blocks;
    for (std::size_t i = 0; i < boxes.blocks.size(); ++i) {
        float depthM = kNoLimitM;
        for (std::size_t span = i * boxes.spans; span < (i + 1) * boxes.spans; ++span)
            if (boxes.boxes[span].meets(box))
                depthM = std::min(depthM, boxes.nearestM[span]);
        if (depthM < kNoLimitM)
            blocks.push_back({.depthM = depthM, .index = static_cast<std::uint32_t>(i)});
    }
    std::ranges::sort(blocks);
    return blocks;
}

} // namespace

TouchedBlocks::TouchedBlocks(const PictureHair& picture, const PictureBrush& brush)
    : m_front(brush.box.widened(kBesideBrushPx), std::max(kLeastCellPx, 2.0F * brush.radiusPx / kCellsAcross)),
      m_deepestM(kNoLimitM)
{
    const std::vector<NearBlock> blocks = blocksNear(picture.boxes, brush.box);
    const FrontHair open = m_front;
    std::size_t some = kFirstBlocks;
    for (std::size_t begin = 0; begin < blocks.size() && blocks[begin].depthM <= m_deepestM; some *= 2) {
        const std::size_t end = std::min(begin + some, blocks.size());
        const std::size_t first = m_parts.size();
        const std::size_t tasks = (end - begin + kBlocksATask - 1) / kBlocksATask;
        m_parts.resize(first + tasks, Part{.touches = {}, .runs = {}, .front = open});
        sim::parallelFor(tasks, 1, [&](std::size_t from, std::size_t to) {
            for (std::size_t task = from; task < to; ++task) {
                Part& part = m_parts[first + task];
                const std::size_t until = std::min(begin + (task + 1) * kBlocksATask, end);
                for (std::size_t i = begin + task * kBlocksATask; i < until; ++i) {
                    touchBlock(picture, blocks[i].index, brush, m_deepestM, part.touches, part.front);
                    part.runs.push_back({.block = blocks[i].index, .end = part.touches.size()});
                }
            }
        });
        for (std::size_t part = first; part < m_parts.size(); ++part)
            m_front.add(m_parts[part].front);
        m_deepestM = m_front.hidesFrom([&brush](glm::vec2 middle) {
            const glm::vec2 way = brush.to - brush.from;
            return glm::distance(middle, brush.from + way * fractionNear(middle, brush.from, brush.to)) <=
                   brush.radiusPx;
        });
        begin = end;
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
