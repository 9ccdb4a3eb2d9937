// Blocks, then skeletons, then drawn curves.
#include "view/picking/struck_strands.h"

#include "sim/base/parallel.h"

#include <array>
#include <bit>
#include <optional>

namespace hairpaint::view {

using model::SeenStrand;

namespace {

constexpr std::size_t kBlocksAtATime = 512;
constexpr std::size_t kStrandsATask = 64;

/// The strands of a block whose curve may meet the line or, with `inside`, lie in it.
std::uint32_t lanesNear(const PictureHair& picture, std::size_t index, const LineRows& line, bool inside)
{
    const auto meets = [&line, inside](const PictureBox& box) {
        return line.mayMeet(box) || (inside && line.contains({box.left, box.top}));
    };
    const std::span boxes(picture.boxes.boxes.data() + index * picture.boxes.spans, picture.boxes.spans);
    if (std::ranges::none_of(boxes, meets))
        return 0;
    const HairBoxes::Block& block = picture.boxes.blocks[index];
    const sim::Groom& groom = *picture.hair->groom;
    const float* node = picture.hair->positions.data() + groom.blocks().index(groom.frameStrand(block.firstSlot), 0);
    std::array<float, 3 * kPickLanes> last{};
    std::array<float, 3 * kPickLanes> next{};
    const float* stray = picture.boxes.strays.data() + index * kPickLanes;
    std::uint32_t found = 0;
    picture.lens.seen(node, last.data());
    for (std::size_t n = 1; n < static_cast<std::size_t>(groom.nodes); ++n, last = next) {
        picture.lens.seen(node + n * sim::StrandBlocks::kNodeStride, next.data());
        for (std::uint32_t lanes = block.lanes & ~found; lanes != 0; lanes &= lanes - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
            const float depth = std::min(last[2 * kPickLanes + lane], next[2 * kPickLanes + lane]);
            if (depth <= 0.0F)
                continue;
            PictureBox box;
            box.add(glm::vec2(last[lane], last[kPickLanes + lane]));
            box.add(glm::vec2(next[lane], next[kPickLanes + lane]));
            if (meets(box.widened(stray[lane] * picture.lens.pxPerM(depth))))
                found |= 1U << lane;
        }
    }
    return found;
}

std::optional<SeenStrand> metAt(const PictureHair& picture, std::uint32_t slot, const LineRows& line, bool inside,
                                bool throughSkin, std::vector<glm::vec3>& points)
{
    picture.drawnCurve(slot, points);
    std::optional<SeenStrand> met;
    float lengthM = 0.0F;
    glm::vec3 last = picture.lens.seen(points.front());
    for (std::size_t i = 1; i < points.size(); ++i) {
        const float stepM = glm::distance(points[i - 1], points[i]);
        if (!met) {
            const glm::vec3 next = picture.lens.seen(points[i]);
            std::optional<float> at;
            if (last.z > 0.0F && next.z > 0.0F)
                at = inside && line.contains(glm::vec2(last)) ? std::optional(0.0F)
                                                              : line.firstMeeting(glm::vec2(last), glm::vec2(next));
            if (at && (throughSkin || !picture.skin.hides(last + (next - last) * *at))) {
                *at = *at * last.z / (*at * last.z + (1.0F - *at) * next.z); // From the picture into the world.
                const glm::vec3 positionWo = points[i - 1] + (points[i] - points[i - 1]) * *at;
                met = SeenStrand{.root = picture.rootOf(slot),
                                 .positionHd = picture.inHead(positionWo),
                                 .alongM = lengthM + stepM * *at,
                                 .fraction = (static_cast<float>(i - 1) + *at) / static_cast<float>(points.size() - 1),
                                 .slot = slot};
            }
            last = next;
        }
        lengthM += stepM;
    }
    if (met)
        met->lengthM = lengthM;
    return met;
}

} // namespace

std::vector<SeenStrand> struckStrands(const PictureHair& picture, const LineRows& line, bool inside, bool throughSkin)
{
    std::vector<std::uint32_t> near(picture.boxes.blocks.size());
    sim::parallelFor(near.size(), kBlocksAtATime, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            near[i] = lanesNear(picture, i, line, inside);
    });
    std::vector<std::uint32_t> slots;
    for (std::size_t i = 0; i < near.size(); ++i)
        for (std::uint32_t lanes = near[i]; lanes != 0; lanes &= lanes - 1)
            slots.push_back(picture.boxes.blocks[i].firstSlot + static_cast<std::uint32_t>(std::countr_zero(lanes)));
    std::vector<std::vector<SeenStrand>> met((slots.size() + kStrandsATask - 1) / kStrandsATask);
    sim::parallelFor(met.size(), 1, [&](std::size_t begin, std::size_t end) {
        std::vector<glm::vec3> points;
        for (std::size_t i = begin * kStrandsATask; i < std::min(slots.size(), end * kStrandsATask); ++i)
            if (const std::optional<SeenStrand> strand = metAt(picture, slots[i], line, inside, throughSkin, points))
                met[i / kStrandsATask].push_back(*strand);
    });
    return joined(met);
}

} // namespace hairpaint::view
