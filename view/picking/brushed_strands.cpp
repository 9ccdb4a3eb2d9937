// Blocks, then strands, then their segments; what other hair or the skin hides is left out last.
#include "view/picking/brushed_strands.h"

#include "sim/base/parallel.h"
#include "view/picking/brush_front.h"
#include "view/picking/curve_batch.h"
#include "view/picking/touch_kernel.h"

#include <algorithm>
#include <array>
#include <bit>
#include <span>

namespace hairpaint::view {

using model::SeenStrand;

namespace {

/// A strand whose skeleton comes near the brush where it is seen.
struct TouchedStrand
{
    std::uint32_t slot;
    std::uint32_t node; ///< The node at the end of the segment that is nearest to the brush's middle.
    float fraction;     ///< Fraction of that segment.
    float first;        ///< Segments and their fraction from the root to where the brush meets it first.
    float apartPx;
    std::uint32_t lastNode; ///< Beyond it the strand is nowhere near the brush.
    bool isMet;             ///< The brush surely meets it; if false its drawn curve must be tested.
};

SeenStrand strandAt(const PictureHair& picture, const TouchedStrand& touched, const PictureBrush& brush)
{
    const sim::Groom& groom = *picture.hair->groom;
    const std::size_t strand = groom.frameStrand(touched.slot);
    const glm::vec3 from = groom.blocks().node(picture.hair->positions, strand, touched.node - 1);
    const glm::vec3 to = groom.blocks().node(picture.hair->positions, strand, touched.node);
    const auto segments = static_cast<float>(groom.nodes - 1);
    const float fraction = (static_cast<float>(touched.node - 1) + touched.fraction) / segments;
    const float lengthM = groom.style(touched.slot).lengthM;
    return {.rootUv = groom.roots->uv[touched.slot],
            .rootHd = groom.roots->positionHd[touched.slot],
            .positionHd = picture.inHead(from + (to - from) * touched.fraction),
            .alongM = lengthM * fraction,
            .lengthM = lengthM,
            .fraction = fraction,
            .firstFraction = touched.first / segments,
            .apart = std::min(touched.apartPx / std::max(brush.radiusPx, 1e-3F), 1.0F),
            .slot = touched.slot};
}

void addTouched(std::uint32_t firstSlot, const BlockTouches& touches, const PictureBrush& brush,
                std::vector<TouchedStrand>& touched)
{
    for (std::uint32_t lanes = touches.strands; lanes != 0; lanes &= lanes - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
        touched.push_back({.slot = firstSlot + static_cast<std::uint32_t>(lane),
                           .node = static_cast<std::uint32_t>(touches.node[lane]),
                           .fraction = touches.fraction[lane],
                           .first = touches.firstNode[lane] - 1.0F + touches.firstFraction[lane],
                           .apartPx = touches.apartPx[lane],
                           .lastNode = static_cast<std::uint32_t>(touches.lastNode[lane]),
                           .isMet = touches.apartPx[lane] + touches.strayPx[lane] <= brush.radiusPx});
    }
}

/// The lanes of a batch whose curves meet the brush.
std::uint32_t lanesMet(CurveBatch& batch, std::uint32_t lanes, const PictureBrush& brush)
{
    const std::span<const std::uint32_t> near = batch.near(brush.box);
    std::uint32_t met = 0;
    for (std::size_t point = 1; point < near.size() && met != lanes; ++point)
        for (std::uint32_t left = lanes & ~met & near[point]; left != 0; left &= left - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(left));
            const glm::vec2 from(batch.seen(point - 1, lane));
            const glm::vec2 to(batch.seen(point, lane));
            if (nearestOf(from, to, brush.from, brush.to).apart <= brush.radiusPx)
                met |= 1U << lane;
        }
    return met;
}

/// Tests the drawn curves of those for which isMet is not known yet, as many at once as there are lanes.
void meetCurves(const PictureBrush& brush, std::vector<TouchedStrand>& touched, CurveBatch& batch)
{
    std::array<TouchedStrand*, kPickLanes> asked{};
    std::array<std::uint32_t, kPickLanes> slots{};
    std::size_t count = 0;
    const auto ask = [&] {
        std::uint32_t last = 0;
        for (std::size_t lane = 0; lane < count; ++lane)
            last = std::max(last, asked[lane]->lastNode);
        batch.evaluate(std::span(slots).first(count), last);
        const std::uint32_t met = lanesMet(batch, (1U << count) - 1U, brush);
        for (std::size_t lane = 0; lane < count; ++lane)
            asked[lane]->isMet = (met >> lane & 1U) != 0;
        count = 0;
    };
    for (TouchedStrand& one : touched) {
        if (one.isMet)
            continue;
        asked[count] = &one;
        slots[count++] = one.slot;
        if (count == kPickLanes)
            ask();
    }
    if (count > 0)
        ask();
}

} // namespace

std::vector<SeenStrand> brushedStrands(const PictureHair& picture, const PictureBrush& brush)
{
    constexpr std::size_t kBlocksATask = 64;
    const BrushFront front(picture, brush);
    const BrushCover cover{.front = front.hair(), .skin = picture.skin, .deepestM = front.deepestM()};
    const std::vector<NearBlock>& blocks = front.blocks();
    std::vector<std::vector<SeenStrand>> met((blocks.size() + kBlocksATask - 1) / kBlocksATask);
    sim::parallelFor(met.size(), 1, [&](std::size_t begin, std::size_t end) {
        std::vector<TouchedStrand> touched;
        CurveBatch batch(picture);
        BlockTouches touches;
        for (std::size_t task = begin; task < end; ++task) {
            touched.clear();
            for (std::size_t i = task * kBlocksATask; i < std::min(blocks.size(), (task + 1) * kBlocksATask); ++i) {
                const BlockQuestion question = front.questionOf(blocks[i]);
                if (question.spans == 0)
                    continue;
                findTouches(picture.lens, question, brush, cover, touches);
                addTouched(picture.boxes.blocks[blocks[i].index].firstSlot, touches, brush, touched);
            }
            meetCurves(brush, touched, batch);
            met[task].reserve(touched.size());
            for (const TouchedStrand& one : touched)
                if (one.isMet)
                    met[task].push_back(strandAt(picture, one, brush));
        }
    });
    return joined(met);
}

} // namespace hairpaint::view
