// Walks a skeleton and adds curl and braid.
#include "sim/groom/strand_curve.h"

#include "sim/base/deterministic.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace hairpaint::sim {

namespace {

constexpr float kPointsPerTurn = 8.0F;
constexpr float kMostSegments = 256.0F;
constexpr float kTiny = 1e-16F;

/// `reference` at unit length in the plane across a unit tangent, or any vector there.
glm::vec3 across(glm::vec3 reference, glm::vec3 tangent)
{
    glm::vec3 v = reference - tangent * glm::dot(reference, tangent);
    float squared = glm::dot(v, v);
    if (squared <= 1e-8F) {
        const glm::vec3 axis = std::abs(tangent.x) < 0.7F ? glm::vec3(1.0F, 0.0F, 0.0F) : glm::vec3(0.0F, 1.0F, 0.0F);
        v = axis - tangent * glm::dot(axis, tangent);
        squared = glm::dot(v, v);
    }
    return v / std::sqrt(squared);
}

struct CurvePoint
{
    glm::vec3 position;
    glm::vec3 derivative;
};

/// Catmull-Rom between nodes; past the ends the curve goes on straight.
CurvePoint catmullRom(std::span<const glm::vec3> nodes, std::size_t segment, float t)
{
    const glm::vec3 p1 = nodes[segment];
    const glm::vec3 p2 = nodes[segment + 1];
    const glm::vec3 p0 = segment > 0 ? nodes[segment - 1] : 2.0F * p1 - p2;
    const glm::vec3 p3 = segment + 2 < nodes.size() ? nodes[segment + 2] : 2.0F * p2 - p1;
    const glm::vec3 c1 = 0.5F * (p2 - p0);
    const glm::vec3 c2 = p0 - 2.5F * p1 + 2.0F * p2 - 0.5F * p3;
    const glm::vec3 c3 = 0.5F * (p3 - p0) + 1.5F * (p1 - p2);
    return {p1 + t * (c1 + t * (c2 + t * c3)), c1 + t * (2.0F * c2 + 3.0F * t * c3)};
}

/// One step of the double reflection: carries `reference` from one point and tangent to the next.
glm::vec3 carried(glm::vec3 reference, glm::vec3 lastPoint, glm::vec3 lastTangent, glm::vec3 point, glm::vec3 tangent)
{
    const glm::vec3 step = point - lastPoint;
    const float squared = glm::dot(step, step);
    if (squared <= kTiny)
        return reference;
    const glm::vec3 reflected = reference - step * (2.0F * glm::dot(step, reference) / squared);
    const glm::vec3 reflectedTangent = lastTangent - step * (2.0F * glm::dot(step, lastTangent) / squared);
    const glm::vec3 second = tangent - reflectedTangent;
    const float secondSquared = glm::dot(second, second);
    if (secondSquared <= kTiny)
        return reflected;
    return reflected - second * (2.0F * glm::dot(second, reflected) / secondSquared);
}

/// Where the middle of a wisp is at an angle of its turn, and how it goes on by a radian; across the braid, in units of
/// r.
struct WispPath
{
    glm::vec2 middle, onward;
};

WispPath wispPath(const StrandStyle& style, float turned)
{
    const auto wisp = static_cast<float>(style.wisp);
    if (style.braid == BraidKind::Twist) {
        const float angle = turned + wisp * glm::pi<float>();
        return {kTwistFraction * glm::vec2(cosDet(angle), sinDet(angle)),
                kTwistFraction * glm::vec2(-sinDet(angle), cosDet(angle))};
    }
    const float w = wisp * (glm::two_pi<float>() / 3.0F);
    const glm::vec3 offset = braidOffset(turned, w);
    return {glm::vec2(offset.x, offset.z), glm::vec2(-sinDet(turned + w), 2.0F * cosDet(2.0F * (turned + w)))};
}

/// The wisp's and the hair's offset at a fraction q of a braid of `lengthM`: x along the frame's first axis, y along
/// the strand, z along the third.
glm::vec3 braidedOffset(const StrandStyle& style, float q, float lengthM)
{
    const float parted = std::min(q * style.braidTurns / kBraidEaseTurns, 1.0F);
    const float r = style.braidRadiusM * (kBraidFirstFraction + (1.0F - kBraidFirstFraction) * parted);
    if (style.braid == BraidKind::Loc)
        return glm::vec3(style.wispOffset.x, 0.0F, style.wispOffset.y) * (r * kLocWispFraction);
    const bool twist = style.braid == BraidKind::Twist;
    const float tuft = std::max(q - (1.0F - kTuftFraction), 0.0F) / kTuftFraction;
    const float tie = std::clamp((q - (1.0F - kTuftFraction - kTieFraction)) / kTieFraction, 0.0F, 1.0F);
    const float tied = tie * tie * (3.0F - 2.0F * tie);
    const float pathR = r * (1.0F + (kTieBraidFraction - 1.0F) * tied) * (1.0F - tuft);
    const float wispR =
        r * (twist ? kTwistWispFraction : kWispRadiusFraction) *
        (1.0F + (kTieWispFraction - 1.0F) * tied + (kTuftWispFraction - kTieWispFraction) * tuft * (2.0F - tuft));
    const float turnRad = glm::two_pi<float>() * style.braidTurns;
    const WispPath path = wispPath(style, turnRad * q);
    // A hair's place in the wisp lies across the wisp's own path, so that wisps are round.
    const glm::vec3 onward(path.onward.x * pathR * turnRad, std::max(lengthM, 1e-6F), path.onward.y * pathR * turnRad);
    const glm::vec3 along = onward / std::sqrt(glm::dot(onward, onward));
    const float aside = std::sqrt(along.y * along.y + along.z * along.z);
    const glm::vec2 place = style.wispOffset * wispR;
    glm::vec3 inWisp(place.x * aside, -(place.x * along.x * along.y + place.y * along.z) / aside,
                     (place.y * along.y - place.x * along.x * along.z) / aside);
    // Along the braid they have the room that their number leaves.
    const float roomM = lengthM * (twist ? kTwistRoomTurns : kPlaitRoomTurns) / std::max(style.braidTurns, 1e-3F);
    inWisp.y *= std::min(1.0F, roomM / std::max(wispR, 1e-6F));
    inWisp.y -= lengthM * kTuftFraction * kTuftUneven * tuft * glm::dot(style.wispOffset, style.wispOffset);
    return glm::vec3(path.middle.x, 0.0F, path.middle.y) * pathR + inWisp;
}

} // namespace

glm::vec3 curlOffset(float t)
{
    const float c = cosDet(t);
    const float s = sinDet(t);
    return {c, s, c * s};
}

glm::vec3 braidOffset(float t, float w)
{
    return {cosDet(t + w), 0.0F, sinDet(2.0F * (t + w))};
}

int curveSegmentsOf(const StrandStyle& style)
{
    float segments = 0.0F;
    if (style.curlRadiusM > 0.0F)
        segments = style.turns * kPointsPerTurn;
    // A wisp swings twice across the braid while it swings once along its width.
    if (style.braid != BraidKind::None)
        segments =
            std::max(segments, style.braidTurns * 2.0F * kPointsPerTurn / std::max(1.0F - style.braidStart, 0.1F));
    return static_cast<int>(std::ceil(std::clamp(segments, 0.0F, kMostSegments)));
}

int segmentsOf(const StrandStyle& style, int nodes)
{
    constexpr int kMost = static_cast<int>(kMostSegments);
    return std::clamp(std::max((nodes - 1) * 2, curveSegmentsOf(style)), 1, kMost);
}

glm::vec3 frameTangentHd(const Groom& groom, std::uint32_t slot)
{
    const RootSet& roots = *groom.roots;
    const auto& chunk = groom.chunks[chunkOf(slot)];
    const std::uint32_t centre = chunk ? chunk->braidCentre[inChunk(slot)] : kNoCentre;
    return roots.tangentHd[centre == kNoCentre ? slot : roots.basisSlot[centre]];
}

void evaluateStrand(std::span<const glm::vec3> skeletonHd, glm::vec3 rootTangentHd, const StrandStyle& style,
                    int segments, std::vector<glm::vec3>& pointsHd)
{
    pointsHd.clear();
    if (skeletonHd.size() < 2 || segments < 1)
        return;
    const std::size_t last = skeletonHd.size() - 1;
    const bool isCurled = style.turns > 0.0F && style.curlRadiusM > 0.0F;
    const bool isBraided = style.braid != BraidKind::None && style.braidStart < 1.0F;
    glm::vec3 lastPoint = skeletonHd[0];
    glm::vec3 lastTangent = across(glm::vec3(0.0F), rootTangentHd); // Only where the skeleton has no direction at all.
    glm::vec3 reference(0.0F);
    const auto shared = static_cast<std::size_t>(std::lround(style.braidStart * static_cast<float>(last))) + 1;
    bool isFramed = !isBraided || shared > last; // As it will be.
    for (int j = 0; j <= segments; ++j) {
        const float s = static_cast<float>(j) / static_cast<float>(segments);
        const float u = s * static_cast<float>(last);
        const std::size_t segment = std::min(static_cast<std::size_t>(u), last - 1);
        const auto [position, derivative] = catmullRom(skeletonHd, segment, u - static_cast<float>(segment));
        const float squared = glm::dot(derivative, derivative);
        const glm::vec3 tangent = squared > kTiny ? derivative / std::sqrt(squared) : lastTangent;
        if (!isFramed && u >= static_cast<float>(shared)) {
            isFramed = true;
            const CurvePoint node = catmullRom(skeletonHd, std::min(shared, last - 1), shared < last ? 0.0F : 1.0F);
            const float nodeSquared = glm::dot(node.derivative, node.derivative);
            lastPoint = node.position;
            lastTangent = nodeSquared > kTiny ? node.derivative / std::sqrt(nodeSquared) : lastTangent;
            reference = across(rootTangentHd, lastTangent);
        }
        reference =
            j == 0 ? across(rootTangentHd, tangent) : carried(reference, lastPoint, lastTangent, position, tangent);
        lastPoint = position;
        lastTangent = tangent;

        glm::vec3 point = position;
        const float gathered = 1.0F + u - style.braidStart * static_cast<float>(last);
        if (isBraided && gathered > 0.0F) {
            const glm::vec3 first = u < static_cast<float>(shared) ? across(rootTangentHd, tangent) : reference;
            const float braidM =
                std::sqrt(squared) * static_cast<float>(skeletonHd.size() - 1) * (1.0F - style.braidStart);
            const float q = std::max(s - style.braidStart, 0.0F) / (1.0F - style.braidStart);
            const glm::vec3 offset = braidedOffset(style, q, braidM) * std::min(gathered, 1.0F);
            point += first * offset.x + tangent * offset.y + glm::cross(first, tangent) * offset.z;
        } else if (isCurled) {
            const glm::vec3 offset = curlOffset(style.phase + glm::two_pi<float>() * style.turns * s) *
                                     (style.curlRadiusM * std::min(1.0F, s / kCurlEaseFraction));
            point += reference * offset.x + glm::cross(tangent, reference) * offset.y + tangent * offset.z;
        }
        pointsHd.push_back(point);
    }
}

} // namespace hairpaint::sim
