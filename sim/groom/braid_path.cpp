// A cubic over the scalp, lifted a little, and a straight line from the centre's root.
#include "sim/groom/braid_path.h"

#include "sim/base/deterministic.h"
#include "sim/groom/strand_curve.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hairpaint::sim {

namespace {

constexpr std::size_t kSamples = 17; ///< Points of a hair's path over the scalp.
constexpr float kLiftM = 0.002F;     ///< Lift of the path's middle: hairs lie on those below them.
/// Lift added to that, as a fraction of the path's chord: a few nodes must clear a round head.
constexpr float kLiftFraction = 0.05F;
constexpr float kPitchRadii = 9.0F; ///< Length of one turn of equation 3, in its radius r.
constexpr float kFourPitch = 1.4F;  ///< Pitch of a flat plait of four strands over that of a plait of three,
constexpr float kFivePitch = 1.8F;  ///< and of five.

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

float pitchOf(BraidKind kind)
{
    return kind == BraidKind::PlaitOfFour ? kFourPitch : kind == BraidKind::PlaitOfFive ? kFivePitch : 1.0F;
}

/// How far hairs spread, over their wisp's radius, at which it touches the wisps that it crosses. More than 1 where
/// there would be gaps: between three wisps that meet, and between those that run side by side in flat braids.
float spreadOf(BraidKind kind)
{
    switch (kind) {
    case BraidKind::Plait:
        return 1.12F;
    case BraidKind::PlaitOfFour:
        return 1.2F;
    case BraidKind::PlaitOfFive:
        return 1.35F;
    case BraidKind::Fishtail:
        return 1.45F;
    default:
        return 1.0F;
    }
}

std::uint16_t in255ths(float fraction)
{
    // Not negative, so that the cast rounds down. NOLINTNEXTLINE(bugprone-incorrect-roundings)
    return static_cast<std::uint16_t>(std::clamp(fraction, 0.0F, 1.0F) * 255.0F + 0.5F);
}

/// How far hairs are from the skeleton at most, in units of r: their wisp's path and its own radius.
float girthFraction(BraidKind kind)
{
    if (kind == BraidKind::None)
        return 0.0F;
    const BraidLacing lacing = lacingOf(kind);
    // The furthest that (cos t, sin 2t) of equation 3 is from 0; a circle keeps its distance.
    constexpr float kCorner = 1.25F;
    const bool isRound = lacing.wisps < 3;
    return lacing.wisp + (isRound ? lacing.path.x : std::max(lacing.path.x, lacing.path.y) * kCorner);
}

/// Draws the hairs of a wisp to the strands that it is made of, so that these are seen.
glm::vec2 inItsStrand(glm::vec2 offset)
{
    constexpr int kStrands = 11;
    constexpr float kDrawn = 0.25F; // More would leave gaps between them.
    constexpr float kGoldenAngle = 2.3999632F;
    glm::vec2 nearest(0.0F);
    float least = 9.0F;
    for (int i = 0; i < kStrands; ++i) {
        const float r = std::sqrt((static_cast<float>(i) + 0.5F) / static_cast<float>(kStrands));
        const float angle = kGoldenAngle * static_cast<float>(i);
        const glm::vec2 middle = r * glm::vec2(cosDet(angle), sinDet(angle));
        const glm::vec2 away = middle - offset;
        if (glm::dot(away, away) < least) {
            least = glm::dot(away, away);
            nearest = middle;
        }
    }
    return offset + (nearest - offset) * kDrawn;
}

/// Factor on a hair's offset in its wisp, 1 for most. Some hairs leave it: more the frizzier they are and the looser
/// the braid is laced.
float astray(const GroupSettings& settings, const StrandStyle& style)
{
    constexpr float kPerMetre = 15.0F;
    constexpr float kLoose = 0.06F;
    constexpr float kFurthest = 0.6F;
    const float fraction = style.frizzM * kPerMetre + std::max(1.0F - 2.0F * settings.braidTightness, 0.0F) * kLoose;
    const float chance = style.variation * 57.3F;
    const float own = chance - std::floor(chance);
    return own < fraction ? 1.0F + kFurthest * own / fraction : 1.0F;
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

CornrowJoin cornrowRest(const RootFrame& root, const BraidRow& row, float radiusM, float tailM,
                        std::span<glm::vec3> nodesHd)
{
    constexpr float kJoinsOnM = 0.006F;
    constexpr float kOverAside = 1.2F;   // From further away at a slant.
    constexpr float kTuckedUnder = 0.7F; // Of its height.
    CornrowJoin join;
    const RowPoint nearest = nearestOnRow(row, root.positionHd);
    join.beforeM = std::min(nearest.alongM + std::max(kJoinsOnM, kOverAside * nearest.asideM), row.lengthM);
    join.lengthM = row.lengthM - join.beforeM + tailM;
    const glm::vec3 chord = onRow(row, join.beforeM, kCornrowAboveRadii * radiusM) - root.positionHd;
    // On a ball the middle of a chord lies a quarter as deep under the skin as its end does under the plane through
    // its begin.
    const float deep = std::max(glm::dot(root.positionHd - onRow(row, join.beforeM, 0.0F), root.normalHd), 0.0F);
    join.scalpM = lengthOf(chord);
    // As even as the rest, so that the curve through the nodes does not swing out.
    const std::size_t last = nodesHd.size() - 1;
    const float evenly = join.scalpM / (join.scalpM + join.lengthM) * static_cast<float>(last);
    const std::size_t gathered = std::clamp<std::size_t>(static_cast<std::size_t>(std::lround(evenly)), 1, last - 1);
    for (std::size_t node = 0; node < gathered; ++node) {
        const float t = static_cast<float>(node) / static_cast<float>(gathered);
        nodesHd[node] = root.positionHd + chord * t + root.normalHd * (t * (1.0F - t) * deep);
    }
    const auto spans = static_cast<float>(last - gathered);
    const bool isTucked = tailM < kLongestTuckedM;
    for (std::size_t node = gathered; node <= last; ++node) {
        const float alongM = join.beforeM + join.lengthM * static_cast<float>(node - gathered) / spans;
        const float inTail = isTucked ? std::max(alongM - row.lengthM, 0.0F) / std::max(tailM, 1e-4F) : 0.0F;
        nodesHd[node] = onRow(row, alongM, kCornrowAboveRadii * radiusM * (1.0F - kTuckedUnder * inTail));
    }
    join.start = static_cast<float>(gathered) / static_cast<float>(last);
    join.end = isTucked ? 1.0F : join.start + (1.0F - join.start) * (row.lengthM - join.beforeM) / join.lengthM;
    return join;
}

std::uint32_t wispCount(BraidKind kind)
{
    return static_cast<std::uint32_t>(lacingOf(kind).wisps);
}

float braidRadiusM(const GroupSettings& settings, float lengthM)
{
    return std::min(settings.braidRadiusM, lengthM * 0.25F);
}

float braidGirthM(BraidKind kind, float radiusM)
{
    return radiusM * girthFraction(kind);
}

float braidBeginsAboveM(BraidKind kind, float radiusM)
{
    // At its begin a braid is one bundle, which lies on the skin.
    constexpr float kPressed = 0.9F;
    const BraidLacing lacing = lacingOf(kind);
    const float bundleM = kPressed * (kBraidFirstFraction * lacing.path.x + kWispFirstFraction * lacing.wisp) * radiusM;
    return std::max(kBraidFirstFraction * braidGirthM(kind, radiusM), bundleM);
}

void placeInWisp(const GroupSettings& settings, const WispChance& chance, StrandStyle& style)
{
    // Tight hair fills its wisp less, loose hair more.
    constexpr float kTightens = 0.3F;
    const float filled = 1.0F + kTightens * (0.5F - settings.braidTightness);
    style.wispOffset = inItsStrand(chance.wispOffset) * (filled * spreadOf(style.braid) * astray(settings, style));
}

void applyBraid(const GroupSettings& settings, BraidKind kind, const WispChance& chance, const BraidMeasures& measures,
                StrandStyle& style)
{
    style.lengthM = measures.scalpM + measures.lengthM;
    style.turns = 0.0F;
    style.curlRadiusM = 0.0F;
    style.phase = 0.0F;
    style.braid = kind;
    style.wisp = static_cast<std::uint8_t>(chance.wisp % wispCount(kind));
    style.braidRadiusM = measures.radiusM;
    style.braidStart =
        static_cast<float>(gatheringNode(settings.nodesPerHair)) / static_cast<float>(settings.nodesPerHair - 1);
    style.braidTurns =
        measures.lengthM / (kPitchRadii * pitchOf(kind) * settings.braidKnot * std::max(measures.radiusM, 1e-4F));
    placeInWisp(settings, chance, style);
    style.braidTaper = in255ths(settings.braidTaper);
    style.braidTied = in255ths(settings.braidTie);
}

} // namespace hairpaint::sim
