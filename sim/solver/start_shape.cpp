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
        const glm::vec3 direction = unitOr(along + (strand.downHd - along) * hangs, strand.downHd);
        const float clearanceM = kSkinClearanceM + std::min(i == 1 ? strand.firstGirthM : strand.girthM,
                                                            kGirthSlope * strand.segmentM * static_cast<float>(i));
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
