// Blocks, then strands, then their segments; what other hair or the skin hides is left out last.
#include "view/picking/brushed_strands.h"

#include "sim/base/parallel.h"
#include "view/picking/front_hair.h"

#include <array>
#include <bit>
#include <cmath>
#include <optional>

namespace hairpaint::view {

using model::SeenStrand;

namespace {

constexpr std::size_t kBlocksATask = 64;
constexpr float kLeastCellPx = 2.0F;
constexpr float kCellsAcross = 16.0F;   ///< The brush.
constexpr std::size_t kLanesAFront = 4; ///< One strand of so many tells where the foremost hair is.
constexpr float kBesideBrushPx = 8.0F;  ///< Hair so near to it is looked at, too: a curl may reach in.

/// A segment of a skeleton that lies under the brush.
struct Touch
{
    std::uint32_t slot;
    std::uint32_t node; ///< At its end.
    float fraction;     ///< Of the segment, where it is nearest.
    float apartPx;      ///< From the brush's middle there,
    float strayPx;      ///< and how far the curve may be from it.
    glm::vec3 seen;     ///< px, depth.
};

struct Nearest
{
    float fraction = 0.0F; ///< Of the first segment.
    float apart = 0.0F;
};

float fractionNear(glm::vec2 point, glm::vec2 from, glm::vec2 to)
{
    const glm::vec2 way = to - from;
    const float square = glm::dot(way, way);
    return square > 0.0F ? std::clamp(glm::dot(point - from, way) / square, 0.0F, 1.0F) : 0.0F;
}

/// Of a segment a-b the point nearest to the segment c-d.
Nearest nearestOf(glm::vec2 a, glm::vec2 b, glm::vec2 c, glm::vec2 d)
{
    const auto apartAt = [&](float fraction) {
        const glm::vec2 point = a + (b - a) * fraction;
        return glm::distance(point, c + (d - c) * fractionNear(point, c, d));
    };
    if (c == d) {
        const float fraction = fractionNear(c, a, b);
        return {.fraction = fraction, .apart = apartAt(fraction)};
    }
    const glm::vec2 way = b - a;
    const glm::vec2 other = d - c;
    const float area = way.x * other.y - way.y * other.x;
    if (std::abs(area) > 1e-9F) {
        const glm::vec2 apart = c - a;
        const float along = (apart.x * other.y - apart.y * other.x) / area;
        const float alongOther = (apart.x * way.y - apart.y * way.x) / area;
        if (along >= 0.0F && along <= 1.0F && alongOther >= 0.0F && alongOther <= 1.0F)
            return {.fraction = along, .apart = 0.0F};
    }
    Nearest best{.fraction = 0.0F, .apart = apartAt(0.0F)};
    for (const float fraction : {1.0F, fractionNear(c, a, b), fractionNear(d, a, b)})
        if (const float apart = apartAt(fraction); apart < best.apart)
            best = {.fraction = fraction, .apart = apart};
    return best;
}

/// Of a block's segments between two nodes, those whose boxes meet a box before the eye: a bit a lane.
std::uint32_t lanesMeeting(const float* from, const float* to, const PictureBox& box)
{
    std::array<std::uint32_t, kPickLanes> flags{};
    for (std::size_t x = 0; x < kPickLanes; ++x) {
        const std::size_t y = kPickLanes + x;
        const std::size_t z = 2 * kPickLanes + x;
        const float left = from[x] < to[x] ? from[x] : to[x];
        const float right = from[x] < to[x] ? to[x] : from[x];
        const float top = from[y] < to[y] ? from[y] : to[y];
        const float bottom = from[y] < to[y] ? to[y] : from[y];
        const float nearest = from[z] < to[z] ? from[z] : to[z];
        flags[x] = static_cast<std::uint32_t>(left <= box.right) & static_cast<std::uint32_t>(right >= box.left) &
                   static_cast<std::uint32_t>(top <= box.bottom) & static_cast<std::uint32_t>(bottom >= box.top) &
                   static_cast<std::uint32_t>(nearest > 0.0F);
    }
    std::uint32_t lanes = 0;
    for (std::size_t lane = 0; lane < kPickLanes; ++lane)
        lanes |= flags[lane] << lane;
    return lanes;
}

/// By strands, root first.
void touchBlock(const PictureHair& picture, std::size_t index, const PictureBrush& brush, std::vector<Touch>& touches,
                FrontHair& front)
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
        const bool meets = picture.boxes.boxes[index * picture.boxes.spans + span].meets(brush.box);
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
    const PictureBox near =
        brush.box.widened(*std::max_element(strays, strays + kPickLanes) * picture.lens.pxPerM(nearestM));
    std::array<std::uint32_t, sim::kMostNodes> meeting{};
    std::uint32_t anywhere = 0;
    for (std::size_t n = 1; n < nodes; ++n)
        if (spanMeets[(n - 1) / HairBoxes::kSpan])
            anywhere |= meeting[n] = block.lanes & lanesMeeting(seen[n - 1].data(), seen[n].data(), near);
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
                                   .seen = from + (to - from) * nearest.fraction});
        }
    }
}

SeenStrand strandAt(const PictureHair& picture, const Touch& touch, const PictureBrush& brush)
{
    const sim::Groom& groom = *picture.hair->groom;
    const std::size_t strand = groom.frameStrand(touch.slot);
    const glm::vec3 from = groom.blocks().node(picture.hair->positions, strand, touch.node - 1);
    const glm::vec3 to = groom.blocks().node(picture.hair->positions, strand, touch.node);
    const float fraction = (static_cast<float>(touch.node - 1) + touch.fraction) / static_cast<float>(groom.nodes - 1);
    const float lengthM = groom.style(touch.slot).lengthM;
    return {.root = picture.rootOf(touch.slot),
            .positionHd = picture.inHead(from + (to - from) * touch.fraction),
            .alongM = lengthM * fraction,
            .lengthM = lengthM,
            .fraction = fraction,
            .apart = std::min(touch.apartPx / std::max(brush.radiusPx, 1e-3F), 1.0F),
            .slot = touch.slot};
}

bool meetsCurve(const PictureHair& picture, std::uint32_t slot, const PictureBrush& brush,
                std::vector<glm::vec3>& points)
{
    picture.drawnCurve(slot, points);
    glm::vec3 last = picture.lens.seen(points.front());
    for (std::size_t i = 1; i < points.size(); ++i) {
        const glm::vec3 next = picture.lens.seen(points[i]);
        PictureBox box;
        box.add(glm::vec2(last));
        box.add(glm::vec2(next));
        if (next.z > 0.0F && last.z > 0.0F && box.meets(brush.box) &&
            nearestOf(glm::vec2(last), glm::vec2(next), brush.from, brush.to).apart <= brush.radiusPx)
            return true;
        last = next;
    }
    return false;
}

} // namespace

std::vector<SeenStrand> brushedStrands(const PictureHair& picture, const PictureBrush& brush)
{
    std::vector<std::uint32_t> blocks;
    for (std::size_t i = 0; i < picture.boxes.blocks.size(); ++i)
        for (std::size_t span = 0; span < picture.boxes.spans; ++span)
            if (picture.boxes.boxes[i * picture.boxes.spans + span].meets(brush.box)) {
                blocks.push_back(static_cast<std::uint32_t>(i));
                break;
            }
    const float cellPx = std::max(kLeastCellPx, 2.0F * brush.radiusPx / kCellsAcross);
    const PictureBox around = brush.box.widened(kBesideBrushPx);
    const std::size_t tasks = (blocks.size() + kBlocksATask - 1) / kBlocksATask;
    std::vector<std::vector<Touch>> touches(tasks);
    std::vector<std::optional<FrontHair>> fronts(tasks);
    sim::parallelFor(tasks, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t task = begin; task < end; ++task) {
            fronts[task].emplace(around, cellPx);
            for (std::size_t i = task * kBlocksATask; i < std::min(blocks.size(), (task + 1) * kBlocksATask); ++i)
                touchBlock(picture, blocks[i], brush, touches[task], *fronts[task]);
        }
    });
    FrontHair front(around, cellPx);
    for (const std::optional<FrontHair>& part : fronts)
        front.add(*part);

    // Of each strand the nearest touch that is seen.
    std::vector<std::vector<SeenStrand>> met(tasks);
    sim::parallelFor(tasks, 1, [&](std::size_t begin, std::size_t end) {
        std::vector<glm::vec3> points;
        for (std::size_t task = begin; task < end; ++task) {
            const std::vector<Touch>& own = touches[task];
            for (std::size_t i = 0; i < own.size();) {
                const Touch* best = nullptr;
                const std::uint32_t slot = own[i].slot;
                for (; i < own.size() && own[i].slot == slot; ++i)
                    if ((best == nullptr || own[i].apartPx < best->apartPx) && !front.hides(own[i].seen) &&
                        !picture.skin.hides(own[i].seen))
                        best = &own[i];
                if (best != nullptr &&
                    (best->apartPx + best->strayPx <= brush.radiusPx || meetsCurve(picture, slot, brush, points)))
                    met[task].push_back(strandAt(picture, *best, brush));
            }
        }
    });
    return joined(met);
}

} // namespace hairpaint::view
