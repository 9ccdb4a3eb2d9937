// Nodes read from the newest frame.
#include "model/tools/shaping/guide_strands.h"

#include <algorithm>
#include <utility>

namespace hairpaint::model {

namespace {

constexpr std::size_t kMostGuides = 24;
constexpr std::size_t kLeastGuides = 12;

const sim::GroupFrame* hairOf(const ToolContext& context)
{
    if (context.hair == nullptr)
        return nullptr;
    const auto group = std::ranges::find_if(context.hair->groups, [&context](const sim::GroupFrame& one) {
        return one.groom != nullptr && one.groom->groupId == context.target.group && !one.positions.empty();
    });
    return group != context.hair->groups.end() ? &*group : nullptr;
}

HairCourse courseOfSlot(const sim::GroupFrame& hair, const sim::HeadPose& pose, std::size_t slot)
{
    HairCourse nodes(static_cast<std::size_t>(hair.groom->nodes));
    hair.groom->blocks().read(hair.positions, hair.groom->frameStrand(slot), nodes);
    for (glm::vec3& node : nodes)
        node = glm::conjugate(pose.rotation) * (node - pose.positionWo);
    return nodes;
}

} // namespace

std::optional<HairCourse> courseOf(const ToolContext& context, const sim::SurfacePoint& root)
{
    const sim::GroupFrame* hair = hairOf(context);
    if (hair == nullptr)
        return std::nullopt;
    const sim::RootSet& roots = *hair->groom->roots;
    std::optional<std::uint32_t> nearest;
    float nearestM = 1e-4F;
    for (std::uint32_t slot = 0; slot < roots.count(); ++slot) {
        const float distanceM = glm::distance(roots.positionHd[slot], root.positionHd);
        if (distanceM < nearestM && hair->isPositioned(slot)) {
            nearestM = distanceM;
            nearest = slot;
        }
    }
    return nearest ? std::optional(courseOfSlot(*hair, context.hair->pose, *nearest)) : std::nullopt;
}

std::vector<GuideStrand> guidesAround(const ToolContext& context, const sim::SurfacePoint& root)
{
    const sim::GroupFrame* hair = hairOf(context);
    if (hair == nullptr)
        return {};
    const sim::RootSet& roots = *hair->groom->roots;
    std::vector<std::pair<float, std::uint32_t>> near; ///< By distance.
    for (const std::uint32_t slot : roots.basisSlot)
        if (hair->isPositioned(slot))
            near.emplace_back(glm::distance(roots.positionHd[slot], root.positionHd), slot);
    std::ranges::sort(near);
    const float reachM = 0.5F * context.settings.brushSizeM;
    const auto within = static_cast<std::size_t>(
        std::ranges::partition_point(near, [reachM](const auto& one) { return one.first <= reachM; }) - near.begin());
    const std::size_t some = std::min(std::max(within, kLeastGuides), near.size());
    const std::size_t count = std::min(some, kMostGuides);
    std::vector<GuideStrand> guides;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t slot = near[i * some / count].second;
        guides.push_back({.root = roots.skin->nearest(roots.positionHd[slot]),
                          .nodesHd = courseOfSlot(*hair, context.hair->pose, slot)});
    }
    return guides;
}

} // namespace hairpaint::model
