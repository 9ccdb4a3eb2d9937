// Bundles are found by their tips.
#include "model/importing/braid_estimate.h"

#include "model/importing/braid_bundle.h"
#include "model/importing/median.h"
#include "model/importing/position_grid.h"
#include "model/importing/touching_sets.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace hairpaint::model {

namespace {

constexpr float kTipCellM = 0.006F;        ///< Side of a cell; tips in cells that touch belong to one bundle.
constexpr std::size_t kFewestStrands = 24; ///< Least number of strands in a bundle,
constexpr std::size_t kFewestOf = 1000;    ///< which also has at least one in this many of all strands.
constexpr float kWidestTipsM = 0.03F;      ///< Greatest root mean square distance of a bundle's tips from their middle.
/// Least fraction of all strands in braids; below it, locks look like braids by chance.
constexpr float kFewBraided = 0.02F;
constexpr float kPatchCellM = 0.005F;
constexpr float kWidestGapM = 0.02F;
constexpr float kWiderThanPatchesM = 0.3F;
constexpr float kSpacingOfNearest = 0.87F;

bool isNarrow(const std::vector<std::uint32_t>& bundle, const std::vector<glm::vec3>& tipsHd)
{
    glm::dvec3 middle(0.0);
    for (const std::uint32_t i : bundle)
        middle += glm::dvec3(tipsHd[i]);
    middle /= static_cast<double>(bundle.size());
    double squares = 0.0;
    for (const std::uint32_t i : bundle)
        squares += glm::dot(glm::dvec3(tipsHd[i]) - middle, glm::dvec3(tipsHd[i]) - middle);
    return squares < static_cast<double>(bundle.size()) * kWidestTipsM * kWidestTipsM;
}

/// How far the roots of different sets are apart at least, as far as it is worth knowing.
float gapM(std::span<const glm::vec3> rootsHd, std::span<const std::vector<std::uint32_t>> patches)
{
    std::vector<std::uint32_t> patchOf(rootsHd.size());
    for (std::uint32_t patch = 0; patch < patches.size(); ++patch)
        for (const std::uint32_t root : patches[patch])
            patchOf[root] = patch;
    const PositionGrid grid(rootsHd, kWidestGapM);
    float squared = kWidestGapM * kWidestGapM;
    for (std::uint32_t root = 0; root < rootsHd.size(); ++root)
        grid.near(rootsHd[root], std::sqrt(squared), [&](std::uint32_t other) {
            const glm::vec3 apart = rootsHd[other] - rootsHd[root];
            if (patchOf[other] != patchOf[root])
                squared = std::min(squared, glm::dot(apart, apart));
            return true;
        });
    return std::sqrt(squared);
}

/// What keeps that many braids apart: where each has a patch of roots of its own, more than a patch is wide; else what
/// is usual between them.
void setSpacing(std::span<const glm::vec3> rootsHd, std::span<const glm::vec3> middlesHd, HeadStrands& onHead)
{
    const std::vector<std::vector<std::uint32_t>> patches = touchingSets(rootsHd, kPatchCellM);
    if (middlesHd.size() < 2 || patches.size() >= middlesHd.size()) {
        onHead.braidSpacingM = kWiderThanPatchesM;
        onHead.braidGapM = gapM(rootsHd, patches);
        return;
    }
    std::vector<float> nearestM;
    for (const glm::vec3& middle : middlesHd) {
        float squared = std::numeric_limits<float>::max();
        for (const glm::vec3& other : middlesHd)
            if (&other != &middle)
                squared = std::min(squared, glm::dot(other - middle, other - middle));
        nearestM.push_back(std::sqrt(squared));
    }
    onHead.braidSpacingM = kSpacingOfNearest * medianOf(nearestM);
}

/// Writes braids into their strands.
void tell(std::span<const FoundBraid> braids, HeadStrands& onHead)
{
    std::vector<float> radiiM;
    std::vector<glm::vec3> rootsHd;   // The roots of all braided strands.
    std::vector<glm::vec3> middlesHd; // By braid: the mean of its roots.
    for (const FoundBraid& braid : braids) {
        radiiM.push_back(braid.radiusM);
        glm::vec3& middleHd = middlesHd.emplace_back(0.0F);
        for (const std::uint32_t index : braid.strands) {
            HeadStrand& strand = onHead.strands[index];
            strand.shape = {.lengthM = braid.lengthM};
            strand.held = 0.0F;
            strand.braid = braid.kind;
            rootsHd.push_back(strand.root.positionHd);
            middleHd += strand.root.positionHd / static_cast<float>(braid.strands.size());
        }
    }
    onHead.braidRadiusM = medianOf(radiiM);
    setSpacing(rootsHd, middlesHd, onHead);
}

} // namespace

bool estimateBraids(const ForeignStrands& strands, const CurveTransform& transform, HeadStrands& onHead,
                    const Progress& progress)
{
    std::vector<glm::vec3> tipsHd;
    tipsHd.reserve(onHead.strands.size());
    for (const HeadStrand& strand : onHead.strands)
        tipsHd.push_back(transform.toHd(strands.strand(strand.source).back()));
    const std::vector<std::vector<std::uint32_t>> bundles = touchingSets(tipsHd, kTipCellM);
    const std::size_t fewest = std::max(kFewestStrands, onHead.strands.size() / kFewestOf);
    std::vector<FoundBraid> braids;
    std::size_t braided = 0;
    for (std::size_t i = 0; i < bundles.size(); ++i) {
        if (progress && !progress(static_cast<double>(i) / static_cast<double>(bundles.size())))
            return false;
        if (bundles[i].size() < fewest || !isNarrow(bundles[i], tipsHd))
            continue;
        std::optional<FoundBraid> braid = braidOf(strands, transform, onHead, bundles[i]);
        if (!braid)
            continue;
        braided += bundles[i].size();
        braids.push_back(std::move(*braid));
    }
    if (!braids.empty() && static_cast<float>(braided) >= kFewBraided * static_cast<float>(onHead.strands.size()))
        tell(braids, onHead);
    return true;
}

} // namespace hairpaint::model
