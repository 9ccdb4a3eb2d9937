// Blocks, then strands, then their segments; what other hair or the skin hides is left out last.
#include "view/picking/brushed_strands.h"

#include "sim/base/parallel.h"
#include "view/picking/curve_batch.h"
#include "view/picking/touched_blocks.h"

#include <array>
#include <bit>
#include <cmath>
#include <compare>
#include <span>

namespace hairpaint::view {

using model::SeenStrand;

namespace {

SeenStrand strandAt(const PictureHair& picture, const Touch& touch, const Touch& first, const PictureBrush& brush)
{
    const sim::Groom& groom = *picture.hair->groom;
    const std::size_t strand = groom.frameStrand(touch.slot);
    const glm::vec3 from = groom.blocks().node(picture.hair->positions, strand, touch.node - 1);
    const glm::vec3 to = groom.blocks().node(picture.hair->positions, strand, touch.node);
    const auto fractionOf = [&groom](const Touch& one) {
        return (static_cast<float>(one.node - 1) + one.fraction) / static_cast<float>(groom.nodes - 1);
    };
    const float fraction = fractionOf(touch);
    const float lengthM = groom.style(touch.slot).lengthM;
    return {.root = picture.rootOf(touch.slot),
            .positionHd = picture.inHead(from + (to - from) * touch.fraction),
            .alongM = lengthM * fraction,
            .lengthM = lengthM,
            .fraction = fraction,
            .firstFraction = fractionOf(first),
            .apart = std::min(touch.apartPx / std::max(brush.radiusPx, 1e-3F), 1.0F),
            .slot = touch.slot};
}

/// The touches of one strand that other hair does not hide.
struct TouchedStrand
{
    const Touch* nearest;
    const Touch* first;
    std::uint32_t lastNode; ///< Beyond it the strand is nowhere near the brush.
    bool isMet;             ///< The brush surely meets it; if false its drawn curve must be tested.
};

/// `touches`: of one block, strand by strand.
void addCandidates(const PictureHair& picture, const TouchedBlocks& touched, std::span<const Touch> touches,
                   const PictureBrush& brush, std::vector<TouchedStrand>& candidates)
{
    for (std::size_t i = 0; i < touches.size();) {
        const Touch* best = nullptr;
        const Touch* first = nullptr;
        std::uint32_t last = 0;
        const std::uint32_t slot = touches[i].slot;
        for (; i < touches.size() && touches[i].slot == slot; ++i) {
            const Touch& touch = touches[i];
            last = touch.node;
            // Only the first touch, and those nearer than the best so far, need the test whether they are hidden.
            if ((first != nullptr && touch.apartPx >= best->apartPx) || touched.hides(touch) ||
                picture.skin.hides(touch.seen))
                continue;
            first = first != nullptr ? first : &touch;
            best = &touch;
        }
        if (best != nullptr)
            candidates.push_back({.nearest = best,
                                  .first = first,
                                  .lastNode = last,
                                  .isMet = best->apartPx + best->strayPx <= brush.radiusPx});
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

/// Tests the drawn curves of candidates for which isMet is not known yet, as many at once as there are lanes.
void meetCurves(const PictureHair& picture, const PictureBrush& brush, std::vector<TouchedStrand>& candidates)
{
    CurveBatch batch(picture);
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
    for (TouchedStrand& one : candidates) {
        if (one.isMet)
            continue;
        asked[count] = &one;
        slots[count++] = one.nearest->slot;
        if (count == kPickLanes)
            ask();
    }
    if (count > 0)
        ask();
}

} // namespace

std::vector<SeenStrand> brushedStrands(const PictureHair& picture, const PictureBrush& brush)
{
    constexpr std::size_t kBlocksAtATime = 32;
    const TouchedBlocks touched(picture, brush);
    const std::vector<std::span<const Touch>> blocks = touched.blocks();
    std::vector<std::vector<SeenStrand>> met((blocks.size() + kBlocksAtATime - 1) / kBlocksAtATime);
    sim::parallelFor(met.size(), 1, [&](std::size_t begin, std::size_t end) {
        std::vector<TouchedStrand> candidates;
        for (std::size_t task = begin; task < end; ++task) {
            candidates.clear();
            for (std::size_t i = task * kBlocksAtATime; i < std::min(blocks.size(), (task + 1) * kBlocksAtATime); ++i)
                addCandidates(picture, touched, blocks[i], brush, candidates);
            meetCurves(picture, brush, candidates);
            for (const TouchedStrand& one : candidates)
                if (one.isMet)
                    met[task].push_back(strandAt(picture, *one.nearest, *one.first, brush));
        }
    });
    return joined(met);
}

} // namespace hairpaint::view
