// Nearest basis hairs by position and normal together, so that an ear does not follow the skull behind it.
#include "sim/groom/basis_neighbours.h"

#include "sim/base/parallel.h"

#include <nanoflann.hpp>

#include <algorithm>
#include <cmath>

namespace hairpaint::sim {

namespace {

constexpr std::size_t kDimensions = 6;
/// One neighbour more than is kept: its distance is where the others' weights reach 0, so that weights change smoothly
/// from root to root although the neighbours are swapped.
constexpr std::size_t kFound = RootSet::kNeighbours + 1;
/// Opposite normals are as far apart as twice this many spacings of basis hairs.
constexpr float kNormalSpacings = 3.0F;
constexpr std::size_t kGrain = 2048;

using Place = std::array<float, kDimensions>;

/// The adaptor that nanoflann asks for.
struct BasisCloud
{
    std::vector<Place> places;
    // The names are nanoflann's.
    [[nodiscard]] std::size_t kdtree_get_point_count() const { return places.size(); }
    [[nodiscard]] float kdtree_get_pt(std::size_t index, std::size_t dimension) const
    {
        return places[index][dimension];
    }
    template<class Box>
    bool kdtree_get_bbox(Box& /*box*/) const
    {
        return false;
    }
};

using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, BasisCloud>, BasisCloud,
                                                 static_cast<int>(kDimensions), std::uint32_t>;

Place placeOf(const RootSet& roots, std::uint32_t slot, float normalScaleM)
{
    const glm::vec3 position = roots.positionHd[slot];
    const glm::vec3 normal = roots.normalHd[slot] * normalScaleM;
    return {position.x, position.y, position.z, normal.x, normal.y, normal.z};
}

/// Shepard's weights as Franke and Nielson 1980 bound them: ((R - d) / (R d))^2, with R the distance of the next one.
std::array<float, RootSet::kNeighbours> weightsOf(const std::array<float, kFound>& distances)
{
    std::array<float, RootSet::kNeighbours> weights{};
    const float reach = distances[kFound - 1];
    float sum = 0.0F;
    for (std::size_t k = 0; k < weights.size(); ++k) {
        const float share = (reach - distances[k]) / std::max(distances[k], 1e-4F * reach + 1e-12F);
        weights[k] = share * share;
        sum += weights[k];
    }
    if (!(sum > 1e-6F)) {
        weights = {1.0F, 0.0F, 0.0F};
        return weights;
    }
    for (float& weight : weights)
        weight /= sum;
    return weights;
}

} // namespace

void findBasisNeighbours(RootSet& roots)
{
    roots.neighbours.assign(roots.count(), {});
    roots.weights.assign(roots.count(), {});
    const std::size_t basisCount = roots.basisSlot.size();
    if (basisCount == 0)
        return;
    const float spacingM = std::sqrt(static_cast<float>(roots.skin->areaM2()) / static_cast<float>(basisCount));
    const float normalScaleM = kNormalSpacings * spacingM;
    BasisCloud cloud;
    cloud.places.reserve(basisCount);
    for (const std::uint32_t slot : roots.basisSlot)
        cloud.places.push_back(placeOf(roots, slot, normalScaleM));
    const Tree tree(static_cast<int>(kDimensions), cloud, nanoflann::KDTreeSingleIndexAdaptorParams(8));

    parallelFor(roots.count(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto slot = static_cast<std::uint32_t>(i);
            const Place place = placeOf(roots, slot, normalScaleM);
            std::array<std::uint32_t, kFound> found{};
            std::array<float, kFound> distances{};
            const std::size_t count = tree.knnSearch(place.data(), kFound, found.data(), distances.data());
            for (std::size_t k = 0; k < kFound; ++k) {
                // With fewer basis hairs than neighbours the last is repeated, and weighs nothing.
                found[k] = found[std::min(k, count - 1)];
                distances[k] = std::sqrt(distances[std::min(k, count - 1)]);
            }
            std::array<std::uint32_t, RootSet::kNeighbours> kept{};
            std::copy_n(found.begin(), kept.size(), kept.begin());
            if (roots.rankOfSlot[slot] >= basisCount) {
                roots.neighbours[slot] = kept;
                roots.weights[slot] = weightsOf(distances);
                continue;
            }
            // A basis hair follows itself, also where another stands on the same spot.
            const auto own = static_cast<std::uint32_t>(
                std::lower_bound(roots.basisSlot.begin(), roots.basisSlot.end(), slot) - roots.basisSlot.begin());
            const auto at = std::find(kept.begin(), kept.end() - 1, own);
            std::copy_backward(kept.begin(), at, at + 1);
            kept[0] = own;
            roots.neighbours[slot] = kept;
            roots.weights[slot] = {1.0F, 0.0F, 0.0F};
        }
    });
}

} // namespace hairpaint::sim
