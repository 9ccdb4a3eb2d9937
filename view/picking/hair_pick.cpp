// Every segment of every drawn hair, as the camera sees it.
#include "view/picking/hair_pick.h"

#include "sim/base/parallel.h"
#include "view/picking/picture_hair.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace hairpaint::view {

namespace {

constexpr std::size_t kSlotsAtOnce = 4096;
constexpr float kBehindMPerPx = 0.001F;

struct Best
{
    float cost = 1e9F;
    std::size_t slot = 0;
    std::size_t segment = 0; ///< Node at the segment's end; 0: none was found.
    float fraction = 0.0F;   ///< 0..1 along the segment.
};

/// What is looked for.
struct Wanted
{
    const sim::GroupFrame& group;
    Lens lens;
    glm::vec2 pointer;
    float depthLimitM;
};

Best bestOf(const Wanted& wanted, std::size_t firstSlot, std::size_t endSlot)
{
    const sim::Groom& groom = *wanted.group.groom;
    const sim::StrandBlocks blocks = groom.blocks();
    std::vector<glm::vec3> nodes(static_cast<std::size_t>(groom.nodes));
    Best best;
    for (std::size_t slot = firstSlot; slot < endSlot; ++slot) {
        if (!wanted.group.isPositioned(slot))
            continue;
        blocks.read(wanted.group.positions, groom.frameStrand(slot), nodes);
        glm::vec3 last = wanted.lens.seen(nodes.front());
        for (std::size_t i = 1; i < nodes.size(); ++i) {
            const glm::vec3 next = wanted.lens.seen(nodes[i]);
            const glm::vec2 segment(next - last);
            const float square = glm::dot(segment, segment);
            const float along =
                square > 0.0F ? std::clamp(glm::dot(wanted.pointer - glm::vec2(last), segment) / square, 0.0F, 1.0F)
                              : 0.0F;
            const glm::vec3 nearest = last + (next - last) * along;
            const float apartPx = glm::distance(glm::vec2(nearest), wanted.pointer);
            const float cost = nearest.z + kBehindMPerPx * apartPx;
            if (cost < best.cost && apartPx <= static_cast<float>(kHairReachPx) && nearest.z > 0.0F &&
                nearest.z < wanted.depthLimitM)
                best = {.cost = cost, .slot = slot, .segment = i, .fraction = along};
            last = next;
        }
    }
    return best;
}

} // namespace

std::optional<model::GrabbedHair> hairNear(QPointF position, const sim::StrandFrame& frame, int group,
                                           const rendering::Camera& camera, QSizeF size, float furthestM)
{
    const auto found = std::ranges::find_if(frame.groups, [group](const sim::GroupFrame& one) {
        return one.groom != nullptr && one.groom->groupId == group;
    });
    if (found == frame.groups.end() || found->positions.empty() || found->groom->roots->count() == 0)
        return std::nullopt;
    const sim::Groom& groom = *found->groom;
    const Wanted wanted{.group = *found,
                        .lens = Lens(camera, size),
                        .pointer = {static_cast<float>(position.x()), static_cast<float>(position.y())},
                        .depthLimitM = furthestM + kOnSkinM};
    const std::size_t slots = groom.roots->count();
    std::vector<Best> parts((slots + kSlotsAtOnce - 1) / kSlotsAtOnce);
    sim::parallelFor(parts.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            parts[i] = bestOf(wanted, i * kSlotsAtOnce, std::min(slots, (i + 1) * kSlotsAtOnce));
    });
    const Best best = *std::ranges::min_element(parts, {}, &Best::cost);
    if (best.segment == 0)
        return std::nullopt;
    std::vector<glm::vec3> nodes(static_cast<std::size_t>(groom.nodes));
    groom.blocks().read(found->positions, groom.frameStrand(best.slot), nodes);
    model::GrabbedHair hair;
    for (std::size_t i = 1; i < best.segment; ++i)
        hair.alongM += glm::distance(nodes[i - 1], nodes[i]);
    const glm::vec3 segment = nodes[best.segment] - nodes[best.segment - 1];
    hair.alongM = std::max(hair.alongM + glm::length(segment) * best.fraction, 1e-4F);
    const glm::vec3 positionWo = nodes[best.segment - 1] + segment * best.fraction;
    hair.positionHd = glm::conjugate(frame.pose.rotation) * (positionWo - frame.pose.positionWo);
    hair.root = groom.roots->surfacePoint(static_cast<std::uint32_t>(best.slot));
    return hair;
}

} // namespace hairpaint::view
