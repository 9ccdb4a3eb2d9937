// From a rank to a hair's own deviations.
#include "sim/groom/variation.h"

#include "sim/base/deterministic.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::sim {

namespace {

constexpr std::uint64_t kVariationKey = 0x7661726961746Eu; ///< Apart from the keys of other uses of the seed.

/// Independent uniform numbers of one hair.
class Chances
{
public:
    Chances(std::uint64_t seed, std::uint32_t rank) : m_key(hash64(seed ^ kVariationKey, rank)) {}
    [[nodiscard]] float unit(std::uint64_t which) const { return unitFloat(hash64(m_key, which)); }
    /// -1..1; values near 0 are the most frequent.
    [[nodiscard]] float around(std::uint64_t which) const
    {
        const std::uint64_t hash = hash64(m_key, which);
        return unitFloat(hash) - unitFloat(hash << 32U);
    }

private:
    std::uint64_t m_key;
};

/// In this order each has chances of its own, whatever else is set.
enum Which : std::uint64_t
{
    Length,
    Turns,
    Radius,
    Width,
    Across,
    Lean,
    Flyaway,
    FlyawayAcross,
    Lift,
    Grey,
    Crosses,
    StrayAcross,
    StrayAlong
};

constexpr float kLeastLengthM = 1e-4F;
constexpr float kOfPatches = 0.1F; ///< Greatest fraction of a hair's length that patches take.

/// 0..1: how far a root lies in a patch of shorter hair.
float inPatch(const VariationSettings& settings, glm::vec3 rootHd)
{
    constexpr float kAcross = 0.45F; ///< Factor on the position given to wavering(): patches are some 5 cm apart.
    constexpr float kPhase = 3.3F;
    return settings.patches * (0.5F + 0.5F * wavering(rootHd * kAcross, kPhase));
}

void varyCurlBy(const VariationSettings& settings, const Chances& chances, HairVariation& own)
{
    if (settings.curl <= 0.0F)
        return;
    own.turns = 1.0F + settings.curl * chances.around(Turns);
    own.radius = 1.0F + settings.curl * chances.around(Radius);
}

} // namespace

HairVariation variationOf(const VariationSettings& settings, std::uint64_t seed, std::uint32_t rank)
{
    HairVariation own;
    if (settings == VariationSettings{})
        return own;
    const Chances chances(seed, rank);
    if (settings.length > 0.0F) {
        // Most hairs reach the line that was cut; few are much shorter.
        const float shortfall = chances.unit(Length);
        own.length = 1.0F - settings.length * shortfall * shortfall;
    }
    varyCurlBy(settings, chances, own);
    if (settings.width > 0.0F)
        own.width = 1.0F + settings.width * chances.around(Width);
    if (settings.crossing > 0.0F) {
        own.acrossRad = settings.crossing * chances.around(Across);
        own.leanRad = settings.crossing * chances.around(Lean);
    }
    if (settings.flyaways > 0.0F && chances.unit(Flyaway) < settings.flyaways) {
        constexpr float kAcrossRad = 0.6F;
        constexpr float kLeastLiftRad = 0.03F;
        constexpr float kMostLiftRad = 0.16F;
        own.isFlyaway = true;
        own.acrossRad += kAcrossRad * chances.around(FlyawayAcross);
        own.liftRad = kLeastLiftRad + (kMostLiftRad - kLeastLiftRad) * chances.unit(Lift);
    }
    own.isGrey = settings.grey > 0.0F && chances.unit(Grey) < settings.grey;
    return own;
}

HairVariation curlVariationOf(const VariationSettings& settings, std::uint64_t seed, std::uint32_t rank)
{
    HairVariation own;
    if (settings.curl > 0.0F)
        varyCurlBy(settings, Chances(seed, rank), own);
    return own;
}

float wavering(glm::vec3 positionHd, float phase)
{
    constexpr float kFirst = 260.0F; // rad/m
    constexpr float kSecond = 430.0F;
    const float first = sinDet(phase + kFirst * (positionHd.x + 0.6F * positionHd.y - 0.8F * positionHd.z));
    const float second = sinDet(1.7F * phase + kSecond * (0.7F * positionHd.x - positionHd.y + 0.5F * positionHd.z));
    return 0.6F * first + 0.4F * second;
}

glm::vec3 strayOf(const VariationSettings& settings, std::uint64_t seed, std::uint32_t rank, glm::vec3 rootHd,
                  const SkinFrame& frame)
{
    if (settings.parting <= 0.0F)
        return glm::vec3(0.0F);
    constexpr float kCrossing = 0.25F; // Fraction of the hairs with the whole reach; the others keep close to the line.
    constexpr float kClose = 0.3F;
    const Chances chances(seed, rank);
    const float reach = chances.unit(Crosses) < kCrossing ? 1.0F : kClose;
    const auto offset = [&](Which which, float phase) {
        const float own = reach * (2.0F * chances.unit(which) - 1.0F);
        return settings.parting * (kPartWavers * wavering(rootHd, phase) + (1.0F - kPartWavers) * own);
    };
    return frame.x * offset(StrayAcross, 0.0F) + frame.y * offset(StrayAlong, kPartAlongPhase);
}

float lengthLeft(const VariationSettings& settings, float ownLength, float lengthM, glm::vec3 rootHd)
{
    const float most = settings.mostShorterM > 0.0F ? settings.mostShorterM / std::max(lengthM, kLeastLengthM) : 1.0F;
    float left = std::max(ownLength, 1.0F - most);
    if (settings.patches > 0.0F)
        left *= 1.0F - inPatch(settings, rootHd) * std::min(kOfPatches, most);
    return left;
}

float lengthBefore(const VariationSettings& settings, float ownLength, float leftM, glm::vec3 rootHd)
{
    const float patch = settings.patches > 0.0F ? inPatch(settings, rootHd) : 0.0F;
    const float mostM = settings.mostShorterM;
    // Each part of lengthLeft() grows with the length, so of the greater of two it is the lesser of their inverses.
    const float shorterM = leftM / (1.0F - kOfPatches * patch);
    if (mostM <= 0.0F)
        return shorterM / ownLength;
    const float shortM = std::min(shorterM / ownLength, shorterM + mostM);
    if (kOfPatches * shortM <= mostM)
        return shortM;
    // Patches take their most, too: own (x - patch most), or (x - most)(1 - patch most / x).
    const float sumM = leftM + mostM + patch * mostM;
    const float rootM = std::sqrt(sumM * sumM - 4.0F * patch * mostM * mostM);
    return std::min(leftM / ownLength + patch * mostM, 0.5F * (sumM + rootM));
}

float densityLeft(const VariationSettings& settings, glm::vec3 rootHd)
{
    constexpr float kThinnest = 0.5F;
    constexpr float kAcross = 0.5F;
    constexpr float kPhase = 0.7F;
    if (settings.patches <= 0.0F)
        return 1.0F;
    return 1.0F - settings.patches * (1.0F - kThinnest) * (0.5F + 0.5F * wavering(rootHd * kAcross, kPhase));
}

glm::vec3 greyed(glm::vec3 colour, float chance)
{
    // White hair keeps a little of the warmth that it had; its lightness differs from hair to hair.
    constexpr glm::vec3 kWhite(0.80F, 0.79F, 0.77F);
    constexpr float kDiffers = 0.08F;
    constexpr float kKept = 0.06F;
    return glm::mix(kWhite * (1.0F + kDiffers * chance), colour, kKept);
}

} // namespace hairpaint::sim
