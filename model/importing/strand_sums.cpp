// Strand by strand, each over the texels near its root.
#include "model/importing/strand_sums.h"

#include "model/importing/strand_spacing.h"
#include "sim/base/rounded.h"
#include "sim/groom/direction_texel.h"
#include "sim/groom/strand_style.h"

#include <algorithm>
#include <span>

namespace hairpaint::model {

namespace {

constexpr float kReachOfSpacing = 1.4F; ///< Standard deviation of a strand's weight, in distances between strands;
constexpr float kReachOfTexel = 0.6F;   ///< no less than this, in texels.
constexpr float kReaches = 2.4F;        ///< Standard deviations until which it weighs.
constexpr float kFurtherReachM = 0.004F;
constexpr float kSameSide = 0.2F;             ///< Cosine between normals of one side of an ear.
constexpr std::size_t kStrandsBetween = 4096; ///< Questions whether it goes on.

float curlOf(float turns)
{
    float low = 0.0F;
    float high = 1.0F;
    for (int i = 0; i < 20; ++i) {
        const float middle = 0.5F * (low + high);
        (sim::turnsOfCurl(middle, false) < turns ? low : high) = middle;
    }
    return high < 1e-4F ? 0.0F : high;
}

/// Texels around a point on the skin and their weights there.
class TexelsAround
{
public:
    explicit TexelsAround(const SkinTexels& texels) : m_texels(texels) {}

    struct Weighed
    {
        std::uint32_t index;
        float weight;
    };
    /// Valid until the next call.
    [[nodiscard]] std::span<const Weighed> at(const SkinDirection& here, float reachM)
    {
        m_found.clear();
        const float furthest2 = kReaches * kReaches * reachM * reachM;
        m_texels.grid->near(here.positionHd, kReaches * reachM, [&](std::uint32_t index) {
            const glm::vec3 aside = m_texels.positionsHd[index] - here.positionHd;
            const float square = glm::dot(aside, aside);
            if (square < furthest2 && glm::dot(m_texels.frame[index].normal, here.normalHd) > kSameSide)
                m_found.push_back({index, sim::expRounded(-0.5F * square / (reachM * reachM))});
            return true;
        });
        return m_found;
    }

private:
    const SkinTexels& m_texels;
    std::vector<Weighed> m_found;
};

void addStrand(const HeadStrand& strand, std::span<const TexelsAround::Weighed> around, const SkinTexels& texels,
               StrandSums& sums)
{
    float area = 0.0F;
    for (const auto& [index, weight] : around)
        area += weight * texels.areaM2[index];
    const float curl = strand.shape.turns > 0.0F ? curlOf(strand.shape.turns) : 0.0F;
    for (const auto& [index, weight] : around) {
        TexelSum& sum = sums.strands[index];
        sum.weight += weight;
        sum.densityPerM2 += weight / area;
        sum.lengthM += weight * strand.shape.lengthM;
        sum.held += weight * strand.held;
        sum.braided[static_cast<int>(strand.braid)] += weight;
        sum.rootColour += weight * strand.look.rootColour;
        sum.tipColour += weight * strand.look.tipColour;
        if (curl > 0.0F) {
            sum.curl += weight * curl;
            sum.radiusM += weight * strand.shape.radiusM;
            sum.coiled += weight;
        }
        sums.roots[index].add(strand.root, weight);
    }
}

} // namespace

void DirectionSum::add(const SkinDirection& here, float added)
{
    const glm::vec3 alongHd = here.directionHd - here.normalHd * glm::dot(here.directionHd, here.normalHd);
    weight += added;
    flatness += added * glm::length(alongHd);
    meanHd += added * alongHd;
    if (added > nearestWeight) {
        nearestWeight = added;
        nearestHd = alongHd;
    }
}

glm::vec2 DirectionSum::in(const sim::SkinFrame& frame) const
{
    const float flat = flatness / weight;
    return sim::shortened(
        sim::turned(frame.fromHd(meanHd / weight), flat, frame.fromHd(nearestHd), sim::kPartedDirections));
}

std::optional<StrandSums> summed(const HeadStrands& onHead, const SkinTexels& texels, const Progress& progress)
{
    const std::vector<float> spacings = strandSpacingsM(onHead.strands);
    StrandSums sums{std::vector<TexelSum>(texels.count()), std::vector<DirectionSum>(texels.count()),
                    std::vector<DirectionSum>(texels.count())};
    TexelsAround around(texels);
    for (std::size_t i = 0; i < onHead.strands.size(); ++i) {
        if (i % kStrandsBetween == 0 && progress &&
            !progress(static_cast<double>(i) / static_cast<double>(onHead.strands.size())))
            return std::nullopt;
        // Where texels are large, as far as the nearest.
        float reachM = std::max(kReachOfSpacing * spacings[i], kReachOfTexel * texels.sideM);
        std::span<const TexelsAround::Weighed> found;
        for (int tries = 0; tries < 4 && found.empty(); ++tries, reachM *= 2.0F)
            found = around.at(onHead.strands[i].root, reachM);
        addStrand(onHead.strands[i], found, texels, sums);
    }
    for (const SkinDirection& here : onHead.further)
        for (const auto& [index, weight] : around.at(here, kFurtherReachM))
            sums.further[index].add(here, weight);
    return sums;
}

} // namespace hairpaint::model
