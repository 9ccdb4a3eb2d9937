// A strand before its first step.
#include "sim/solver/start_shape.h"

#include "sim/solver/solver_layout.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::sim {

namespace {

glm::vec3 unitOr(glm::vec3 v, glm::vec3 fallback)
{
    const float square = glm::dot(v, v);
    return square > 1e-12F ? v / std::sqrt(square) : fallback;
}

glm::vec3 outOfSkin(const DistanceGrid& grid, const glm::vec3& node, float clearanceM)
{
    const std::optional<DistanceGrid::Sample> sample = grid.at(node);
    if (!sample || sample->distanceM >= clearanceM)
        return node;
    const float slope2 = std::max(glm::dot(sample->gradient, sample->gradient), 0.04F);
    return node + sample->gradient * ((clearanceM - sample->distanceM) / slope2);
}

/// Where hair goes on that comes down on a shoulder at `parent`, about to go by `along`: downhill, but no further to
/// the side, where its weight would draw it out like a tent.
glm::vec3 overShoulder(const DistanceGrid& grid, const HangingStrand& strand, const glm::vec3& root,
                       const glm::vec3& parent, const glm::vec3& along)
{
    constexpr float kFarBelowM = 0.08F;
    constexpr float kNearM = 0.002F;
    constexpr float kFacesUp = 0.3F;
    constexpr float kRidge = 0.3F; // On the ridge of a shoulder it falls to the side that it grew on.
    if (glm::dot(parent - root, strand.downHd) < kFarBelowM)
        return along;
    const std::optional<DistanceGrid::Sample> sample = grid.at(parent + along * strand.segmentM);
    if (!sample || sample->distanceM > kNearM)
        return along;
    const glm::vec3 normal = unitOr(sample->gradient, -strand.downHd);
    const float up = -glm::dot(normal, strand.downHd);
    if (up < kFacesUp)
        return along;
    glm::vec3 downhill = strand.downHd + normal * up;
    if (downhill.x * parent.x > 0.0F)
        downhill.x = 0.0F;
    if (std::abs(downhill.z) < kRidge)
        downhill.z = root.z < parent.z ? -kRidge : kRidge;
    return unitOr(downhill, along);
}

} // namespace

void hangStrand(std::span<glm::vec3> nodesHd, std::span<const glm::vec3> restHd, const HangingStrand& strand,
                const ColliderSet& colliders, std::span<const float> scales)
{
    nodesHd[0] = restHd[0];
    for (std::size_t i = 1; i < nodesHd.size(); ++i) {
        const glm::vec3 parent = nodesHd[i - 1];
        const glm::vec3 along = unitOr(restHd[i] - restHd[i - 1], strand.downHd);
        // Carried over one such length, hanging after three.
        const float carried = strand.segmentM * static_cast<float>(i) / std::max(strand.stiffnessM, 1e-3F);
        const float hangs = std::clamp((carried - 1.0F) * 0.5F, 0.0F, 1.0F);
        glm::vec3 direction = unitOr(along + (strand.downHd - along) * hangs, strand.downHd);
        if (strand.sheds && colliders.grid)
            direction = overShoulder(*colliders.grid, strand, nodesHd[0], parent, direction);
        const float clearanceM =
            kSkinClearanceM + std::min(strand.girthM, kGirthSlope * strand.segmentM * static_cast<float>(i));
        glm::vec3 node = parent + direction * strand.segmentM;
        for (int pass = 0; pass < 2; ++pass) {
            for (int c = 0; c < colliders.count; ++c) {
                const auto index = static_cast<std::size_t>(c);
                node = colliders.items[index].pushedOut(node, scales[index]);
            }
            if (colliders.grid)
                node = outOfSkin(*colliders.grid, node, clearanceM);
            node += (restHd[i] - node) * strand.styled;
            node = parent + unitOr(node - parent, direction) * strand.segmentM;
        }
        nodesHd[i] = node;
    }
}

} // namespace hairpaint::sim
