// The lie of the hair on the head.
#include "sim/solver/start_shape.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::sim {

namespace {

constexpr float kPartingBlurM = 0.003F; ///< Hairs of both sides mix over this width.
constexpr float kLift = 0.22F;          ///< Of long hair, off the skin: tangent of the angle.
constexpr float kStiffM = 0.03F;        ///< Hair shorter than this stands on its own;
constexpr float kLimpM = 0.14F;         ///< longer than this lies.
constexpr float kSideways = 4.0F;       ///< At full parting, on top and at the forehead, against 1 for down.
constexpr float kBackward = 3.6F;       ///< At full sweep.

float smooth(float from, float to, float x)
{
    const float t = std::clamp((x - from) / (to - from), 0.0F, 1.0F);
    return t * t * (3.0F - 2.0F * t);
}

glm::vec3 unitOr(glm::vec3 v, glm::vec3 fallback)
{
    const float square = glm::dot(v, v);
    return square > 1e-12F ? v / std::sqrt(square) : fallback;
}

glm::vec3 outOfSkin(const DistanceGrid& grid, const glm::vec3& node)
{
    const std::optional<DistanceGrid::Sample> sample = grid.at(node);
    if (!sample || sample->distanceM >= kSkinClearanceM)
        return node;
    const float slope2 = std::max(glm::dot(sample->gradient, sample->gradient), 0.04F);
    return node + sample->gradient * ((kSkinClearanceM - sample->distanceM) / slope2);
}

} // namespace

glm::vec3 lieDirection(const StrandRoot& root)
{
    const glm::vec3 n = root.normalHd;
    const float up = std::clamp(n.y, 0.0F, 1.0F);
    const float side = root.positionHd.x + (root.hash01 - 0.5F) * kPartingBlurM < 0.0F ? -1.0F : 1.0F;
    const float front = std::clamp(n.z, 0.0F, 1.0F);
    const float combing = std::max(up, front);
    // Over the face nothing falls straight down once it is combed at all.
    const float down = 1.0F - front * std::min(1.0F, root.parting + root.sweepBack);
    const glm::vec3 combed(kSideways * root.parting * combing * side, -down, -kBackward * root.sweepBack * combing);
    const glm::vec3 along = unitOr(combed - n * glm::dot(combed, n), glm::vec3(side, 0.0F, 0.0F));
    const float loose = 1.0F - root.gel;
    const float laid = loose * loose * (1.0F - root.body) * smooth(kStiffM, kLimpM, root.lengthM);
    return unitOr(n + (unitOr(along + n * kLift, n) - n) * laid, n);
}

void hangStrand(std::span<glm::vec3> nodesHd, std::span<const glm::vec3> restHd, glm::vec3 lie, glm::vec3 downHd,
                float segmentM, float styled, const ColliderSet& colliders, std::span<const float> scales)
{
    constexpr float kBend = 0.4F; ///< Toward down, from segment to segment.
    nodesHd[0] = restHd[0];
    glm::vec3 direction = lie;
    for (std::size_t i = 1; i < nodesHd.size(); ++i) {
        const glm::vec3 parent = nodesHd[i - 1];
        glm::vec3 node = parent + direction * segmentM;
        for (int pass = 0; pass < 2; ++pass) {
            for (int c = 0; c < colliders.count; ++c) {
                const auto index = static_cast<std::size_t>(c);
                node = colliders.items[index].pushedOut(node, scales[index]);
            }
            if (colliders.grid)
                node = outOfSkin(*colliders.grid, node);
            node += (restHd[i] - node) * styled;
            node = parent + unitOr(node - parent, lie) * segmentM;
        }
        nodesHd[i] = node;
        direction = unitOr((node - parent) / segmentM * (1.0F - kBend) + downHd * kBend, downHd);
    }
}

} // namespace hairpaint::sim
