// A cubic over the scalp, lifted a little, and a straight line from the centre's root.
#include "sim/groom/braid_path.h"

#include "sim/groom/strand_curve.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hairpaint::sim {

namespace {

constexpr std::size_t kSamples = 17;   ///< Of the part on the scalp.
constexpr float kLiftM = 0.002F;       ///< Hairs on their way lie on those below them,
constexpr float kLiftFraction = 0.05F; ///< and are lifted by this fraction of it: a few nodes must clear a round head.
constexpr float kPitchRadii = 9.0F;    ///< Length of one turn of equation 3, in its radius r.

float lengthOf(glm::vec3 v)
{
    return std::sqrt(glm::dot(v, v));
}

/// The direction of `direction` in the plane of the normal, unit; 0 where there is none.
glm::vec3 alongSkin(glm::vec3 direction, glm::vec3 normal)
{
    const glm::vec3 flat = direction - normal * glm::dot(direction, normal);
    const float length = lengthOf(flat);
    return length > 1e-9F ? flat / length : glm::vec3(0.0F);
}

/// Bezier's cubic that leaves and arrives along the skin. For two points on a circle its handles, 2/3 of the chord over
/// 1 + cos of half the angle, are those of the circle's arc.
std::array<glm::vec3, kSamples> scalpPath(const RootFrame& from, const RootFrame& to, float aboveM)
{
    const glm::vec3 chord = to.positionHd - from.positionHd;
    const float cosAngle = glm::dot(from.normalHd, to.normalHd);
    const float cosHalf = std::sqrt(std::max(0.5F + 0.5F * cosAngle, 0.0F));
    const float handle = lengthOf(chord) * (2.0F / 3.0F) / (1.0F + cosHalf);
    const glm::vec3 b1 = from.positionHd + alongSkin(chord, from.normalHd) * handle;
    const glm::vec3 b2 = to.positionHd - alongSkin(chord, to.normalHd) * handle;
    const float liftM = std::min(kLiftM + lengthOf(chord) * kLiftFraction, lengthOf(chord) * 0.25F);
    std::array<glm::vec3, kSamples> path;
    for (std::size_t i = 0; i < kSamples; ++i) {
        const float t = static_cast<float>(i) / static_cast<float>(kSamples - 1);
        const float u = 1.0F - t;
        path[i] = from.positionHd * (u * u * u) + b1 * (3.0F * u * u * t) + b2 * (3.0F * u * t * t) +
                  to.positionHd * (t * t * t) + (from.normalHd * u + to.normalHd * t) * (4.0F * u * t * liftM) +
                  to.normalHd * (t * t * aboveM);
    }
    return path;
}

/// Equation 3's radius r; that of a short braid is smaller.
float braidRadiusM(const GroupSettings& settings, float lengthM)
{
    return std::min(settings.braidRadiusM, lengthM * 0.25F);
}

/// How far hairs are from the skeleton at most, in units of r: their wisp's path and its own radius.
float girthFraction(BraidKind kind)
{
    switch (kind) {
    case BraidKind::None:
        return 0.0F;
    case BraidKind::Plait:
        return 1.25F + kWispRadiusFraction; // The furthest that (cos t, sin 2t) of equation 3 is from 0.
    case BraidKind::Twist:
        return kTwistFraction + kTwistWispFraction;
    case BraidKind::Loc:
        return kLocWispFraction;
    }
    return 0.0F;
}

} // namespace

int gatheringNode(int nodes)
{
    return std::max((nodes + 1) / 4, 1);
}

float braidRest(const RootFrame& root, const RootFrame& centre, float aboveM, float centreLengthM,
                std::span<glm::vec3> nodesHd)
{
    const std::array<glm::vec3, kSamples> path = scalpPath(root, centre, aboveM);
    std::array<float, kSamples> lengthUpTo{};
    for (std::size_t i = 1; i < kSamples; ++i)
        lengthUpTo[i] = lengthUpTo[i - 1] + lengthOf(path[i] - path[i - 1]);
    const float scalpM = lengthUpTo.back();
    const auto gathered = static_cast<std::size_t>(gatheringNode(static_cast<int>(nodesHd.size())));
    std::size_t at = 0;
    for (std::size_t node = 0; node < gathered; ++node) {
        const float s = scalpM * static_cast<float>(node) / static_cast<float>(gathered);
        while (at + 2 < kSamples && lengthUpTo[at + 1] <= s)
            ++at;
        const float fraction = (s - lengthUpTo[at]) / std::max(lengthUpTo[at + 1] - lengthUpTo[at], 1e-12F);
        nodesHd[node] = path[at] + (path[at + 1] - path[at]) * fraction;
    }
    const float segmentM = centreLengthM / static_cast<float>(nodesHd.size() - 1 - gathered);
    for (std::size_t node = gathered; node < nodesHd.size(); ++node)
        nodesHd[node] = centre.positionHd + centre.normalHd * (aboveM + segmentM * static_cast<float>(node - gathered));
    return scalpM;
}

std::uint32_t wispCount(BraidKind kind)
{
    return kind == BraidKind::Plait ? 3 : kind == BraidKind::Twist ? 2 : 1;
}

float braidGirthM(const GroupSettings& settings, BraidKind kind, float lengthM)
{
    return braidRadiusM(settings, lengthM) * girthFraction(kind);
}

float braidBeginsAboveM(const GroupSettings& settings, BraidKind kind, float lengthM)
{
    return kBraidFirstFraction * braidGirthM(settings, kind, lengthM);
}

void applyBraid(const GroupSettings& settings, BraidKind kind, const WispChance& chance, float scalpM,
                float centreLengthM, StrandStyle& style)
{
    style.lengthM = scalpM + centreLengthM;
    style.turns = 0.0F;
    style.curlRadiusM = 0.0F;
    style.phase = 0.0F;
    style.braid = kind;
    style.wisp = static_cast<std::uint8_t>(chance.wisp % wispCount(kind));
    style.braidRadiusM = braidRadiusM(settings, centreLengthM);
    style.braidStart =
        static_cast<float>(gatheringNode(settings.nodesPerHair)) / static_cast<float>(settings.nodesPerHair - 1);
    style.braidTurns = centreLengthM / (kPitchRadii * std::max(settings.braidRadiusM, 1e-4F));
    style.wispOffset = chance.wispOffset;
}

} // namespace hairpaint::sim
