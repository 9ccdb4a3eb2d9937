// By the distance of one of the nearest neighbours.
#include "model/importing/strand_spacing.h"

#include "model/importing/position_grid.h"
#include "sim/base/parallel.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace hairpaint::model {

namespace {

constexpr std::size_t kNeighboursCounted = 8; ///< By which it is found how far apart strands stand.
constexpr float kFurthestApartM = 0.03F;
constexpr std::array kLookedAroundM{0.003F, 0.006F, 0.012F, 0.024F, 0.048F, 0.096F};
constexpr std::size_t kMostLookedAt = 512; ///< All of them may have one root.

} // namespace

std::vector<float> strandSpacingsM(const std::vector<HeadStrand>& strands)
{
    std::vector<glm::vec3> rootsHd;
    rootsHd.reserve(strands.size());
    for (const HeadStrand& strand : strands)
        rootsHd.push_back(strand.root.positionHd);
    const PositionGrid grid(rootsHd, 0.003F);
    std::vector<float> spacings(strands.size(), kFurthestApartM);
    const float perRadius = std::sqrt(glm::pi<float>() / static_cast<float>(kNeighboursCounted));
    sim::parallelFor(strands.size(), 256, [&](std::size_t begin, std::size_t end) {
        std::vector<float> squares;
        for (std::size_t i = begin; i < end; ++i)
            for (const float radiusM : kLookedAroundM) {
                squares.clear();
                grid.near(rootsHd[i], radiusM, [&](std::uint32_t other) {
                    const glm::vec3 offset = rootsHd[other] - rootsHd[i];
                    if (const float square = glm::dot(offset, offset); square <= radiusM * radiusM)
                        squares.push_back(square);
                    return squares.size() < kMostLookedAt;
                });
                if (squares.size() <= kNeighboursCounted)
                    continue;
                // The first is the strand itself.
                std::ranges::nth_element(squares, squares.begin() + kNeighboursCounted);
                spacings[i] = std::min(perRadius * std::sqrt(squares[kNeighboursCounted]), kFurthestApartM);
                break;
            }
    });
    return spacings;
}

} // namespace hairpaint::model
