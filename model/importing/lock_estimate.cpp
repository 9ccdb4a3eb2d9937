// Hairs of a lock are drawn to one phase: of two of them, phases are apart by what is left of their own difference,
// which is that of two uniform ones. The mean cosine of that is sinc^2(1 - clump). The further two hairs are apart, the
// less likely they are of one lock: where locks lie as Voronoi cells of random points, a line of length d crosses 1.27
// d / sqrt(area of a cell) edges in the mean.
#include "model/importing/lock_estimate.h"

#include "model/importing/position_grid.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace hairpaint::model {

namespace {

constexpr std::size_t kMostAsked = 3000;
constexpr std::size_t kMostRanks = 256;          ///< Neighbours of each.
constexpr std::size_t kMostLookedThrough = 8192; ///< All of them may have one root.
constexpr std::size_t kBins = 8;                 ///< Neighbours 1, 2 to 3, 4 to 7, and so on.
constexpr float kLeastAgreement = 0.2F;
constexpr double kSurelyTogether =
    0.6; ///< Further off, what locks look like counts more than how many edges there are.
constexpr float kCrossings = 1.27F;

struct Agreement
{
    double sum = 0.0;
    double count = 0.0;
    [[nodiscard]] float mean() const { return count > 0.0 ? static_cast<float>(sum / count) : 0.0F; }
};

/// Mean cosine between a coil's phase and those of its neighbours, by how many are nearer.
std::array<Agreement, kBins> agreements(std::span<const HeadStrand> coils)
{
    std::vector<glm::vec3> rootsHd;
    rootsHd.reserve(coils.size());
    for (const HeadStrand& strand : coils)
        rootsHd.push_back(strand.root.positionHd);
    const PositionGrid grid(rootsHd, 0.004F);
    std::array<Agreement, kBins> bins;
    std::vector<std::pair<float, std::uint32_t>> near;
    const std::size_t step = std::max<std::size_t>(coils.size() / kMostAsked, 1);
    for (std::size_t i = 0; i < coils.size(); i += step) {
        for (const float radiusM : {0.008F, 0.016F, 0.032F, 0.064F}) {
            near.clear();
            grid.near(rootsHd[i], radiusM, [&](std::uint32_t other) {
                const float distance = glm::distance(rootsHd[other], rootsHd[i]);
                if (other != i && distance < radiusM)
                    near.emplace_back(distance, other);
                return near.size() < kMostLookedThrough;
            });
            if (near.size() >= kMostRanks)
                break;
        }
        const std::size_t ranks = std::min(near.size(), kMostRanks - 1);
        std::ranges::partial_sort(near, near.begin() + static_cast<std::ptrdiff_t>(ranks));
        for (std::size_t rank = 0, bin = 0; rank < ranks; ++rank) {
            if (rank + 2 > std::size_t{2} << bin)
                ++bin;
            bins[bin].sum += glm::dot(coils[i].shape.asideHd, coils[near[rank].second].shape.asideHd);
            bins[bin].count += 1.0;
        }
    }
    return bins;
}

float clumpOf(float agreement)
{
    float low = 0.0F;
    float high = 1.0F;
    for (int i = 0; i < 20; ++i) {
        const float middle = 0.5F * (low + high);
        const float left = glm::pi<float>() * std::max(1.0F - middle, 1e-4F);
        const float sinc = std::sin(left) / left;
        (sinc * sinc < agreement ? low : high) = middle;
    }
    return low;
}

} // namespace

LockEstimate estimateLocks(std::span<const HeadStrand> strands)
{
    std::vector<HeadStrand> coils;
    std::ranges::copy_if(strands, std::back_inserter(coils),
                         [](const HeadStrand& strand) { return strand.shape.turns > 0.0F; });
    if (coils.size() < kMostRanks || 2 * coils.size() < strands.size())
        return {};
    const std::array<Agreement, kBins> bins = agreements(coils);
    if (bins[0].mean() < kLeastAgreement)
        return {};
    // ln(agreement) falls with the root of the number of nearer neighbours: a line through what is well above chance.
    double weights = 0.0;
    double x = 0.0;
    double y = 0.0;
    double xx = 0.0;
    double xy = 0.0;
    for (std::size_t bin = 0; bin < kBins; ++bin) {
        const double mean = bins[bin].mean();
        if (mean < kSurelyTogether * bins[0].mean())
            break;
        const double apart = std::sqrt(1.5 * std::pow(2.0, static_cast<double>(bin)) - 0.5);
        weights += 1.0;
        x += apart;
        y += std::log(mean);
        xx += apart * apart;
        xy += apart * std::log(mean);
    }
    const double across = weights * xx - x * x;
    const double slope = across > 0.0 ? std::min((weights * xy - x * y) / across, -1e-3) : -1.0;
    const double crossing = kCrossings / std::sqrt(glm::pi<double>());
    const double hairs = std::pow(crossing / slope, 2.0);
    const double together = std::exp((y - slope * x) / weights);
    return {.clump = clumpOf(static_cast<float>(std::min(together, 1.0))),
            .hairs = static_cast<float>(std::clamp(hairs, 2.0, 5000.0))};
}

} // namespace hairpaint::model
