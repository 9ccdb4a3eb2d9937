// Walks a skeleton and adds curl and braid.
#include "sim/groom/strand_curve.h"

#include "sim/base/deterministic.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hairpaint::sim {

namespace {

constexpr float kPointsPerTurn = 8.0F;
constexpr float kMostSegments = 256.0F;
constexpr float kMostOfCoils = 1024.0F; ///< The finest have a turn every 2 mm.
constexpr float kUpright = 1e-4F;       ///< Squared sine to the normal below which a hair lies to no side.

/// The formula for one strand, in floats.
namespace of_floats {

using Num = float;
using Vec3 = glm::vec3;
using Flag = bool;

float sinOf(float x)
{
    return sinDet(x);
}
float cosOf(float x)
{
    return cosDet(x);
}
float root(float x)
{
    return std::sqrt(x);
}
float floored(float x)
{
    return std::floor(x);
}
float least(float a, float b)
{
    return std::min(a, b);
}
float most(float a, float b)
{
    return std::max(a, b);
}
float clamped(float x, float low, float high)
{
    return std::clamp(x, low, high);
}
float mixed(float a, float b, float t)
{
    return a + (b - a) * t;
}
float over(float x, float constant)
{
    return x / constant;
}
bool everywhere(bool flag)
{
    return flag;
}
template<typename T>
T select(bool yes, const T& a, const T& b)
{
    return yes ? a : b;
}
glm::vec3 vec3Of(float x, float y, float z)
{
    return {x, y, z};
}
glm::vec3 unitOf(glm::vec3 v, float squared)
{
    return v / std::sqrt(squared);
}
glm::vec3 reflectedIn(glm::vec3 v, glm::vec3 axis, float squared)
{
    return v - axis * (2.0F * glm::dot(axis, v) / squared);
}

#define CURVE_FUNCTION inline
#include "sim/groom/curve_formula.inl"
#undef CURVE_FUNCTION

} // namespace of_floats

of_floats::Span spanOf(std::span<const glm::vec3> nodes, std::size_t segment, bool isTaut)
{
    const glm::vec3 p1 = nodes[segment];
    const glm::vec3 p2 = nodes[segment + 1];
    const auto beforeRoot = [&] {
        return isTaut && nodes.size() > 2 ? of_floats::beyondBent(p1, p2, nodes[2]) : of_floats::beyond(p1, p2);
    };
    return of_floats::spanOf(segment > 0 ? nodes[segment - 1] : beforeRoot(), p1, p2,
                             segment + 2 < nodes.size() ? nodes[segment + 2] : of_floats::beyond(p2, p1));
}

/// Walks along a skeleton: the curve at fractions of it, which rise.
class SkeletonWalk
{
public:
    SkeletonWalk(std::span<const glm::vec3> nodes, bool isTaut) : m_nodes(nodes), m_isTaut(isTaut) {}

    void goTo(float s)
    {
        const std::size_t last = m_nodes.size() - 1;
        m_u = s * static_cast<float>(last);
        const std::size_t segment = std::min(static_cast<std::size_t>(m_u), last - 1);
        if (segment != m_segment) {
            m_segment = segment;
            m_span = spanOf(m_nodes, segment, m_isTaut);
        }
    }
    [[nodiscard]] float u() const { return m_u; } ///< By node.
    [[nodiscard]] glm::vec3 position() const { return of_floats::positionAt(m_span, t()); }
    [[nodiscard]] glm::vec3 derivative() const { return of_floats::derivativeAt(m_span, t()); }

private:
    [[nodiscard]] float t() const { return m_u - static_cast<float>(m_segment); }

    std::span<const glm::vec3> m_nodes;
    bool m_isTaut;
    std::size_t m_segment = std::numeric_limits<std::size_t>::max();
    float m_u = 0.0F;
    of_floats::Span m_span{};
};

/// The wisp's and the hair's offset at a fraction q of a braid of `lengthM`: x along the frame's first axis, y along
/// the strand, z along the third.
glm::vec3 braidedOffset(const StrandStyle& style, float q, float lengthM)
{
    constexpr float kWhole = 255.0F;
    return of_floats::braidedOffset({.radiusM = style.braidRadiusM,
                                     .turns = style.braidTurns,
                                     .begun = style.phase,
                                     .wispX = style.wispOffset.x,
                                     .wispY = style.wispOffset.y,
                                     .chance = style.variation,
                                     .taper = static_cast<float>(style.braidTaper) / kWhole,
                                     .tied = static_cast<float>(style.braidTied) / kWhole},
                                    static_cast<float>(style.braid), static_cast<float>(style.wispNumber()), q,
                                    lengthM);
}

} // namespace

glm::vec3 curlOffset(float t)
{
    return of_floats::curlOffset(t);
}

glm::vec3 coilOffset(const StrandStyle& style, const CurlSettings& curl, float s)
{
    return of_floats::coilOffset({.turns = style.turns,
                                  .radiusM = style.curlRadiusM,
                                  .phase = style.phase,
                                  .chance = style.variation,
                                  .lengthM = style.lengthM * (1.0F - style.braidStart)},
                                 {.inStepFromM = curl.inStepFromM,
                                  .switchbacksPerM = curl.switchbacksPerM,
                                  .skips = curl.skips,
                                  .flatness = curl.flatness,
                                  .uncoil = curl.uncoil,
                                  .straightM = curl.straightM},
                                 s);
}

BraidLacing lacingOf(BraidKind kind)
{
    const of_floats::Lacing lacing = of_floats::lacingOf(static_cast<float>(kind));
    return {.wisps = static_cast<int>(lacing.wisps),
            .swings = lacing.swings,
            .path = {lacing.pathX, lacing.pathZ},
            .wisp = lacing.wisp};
}

glm::vec3 braidOffset(float t, float w)
{
    const of_floats::WispPath path =
        of_floats::wispPath(of_floats::lacingOf(static_cast<float>(BraidKind::Plait)), t + w);
    return {path.x, 0.0F, path.z};
}

FrizzOfStyle frizzOf(const StrandStyle& style)
{
    const of_floats::Frizz frizz = of_floats::frizzOf(style.frizzM, style.lengthM);
    return {.radiusM = frizz.radiusM, .waveRad = frizz.waveRad};
}

int curveSegmentsOf(const StrandStyle& style, const CurlSettings* coils)
{
    float segments = 0.0F;
    if (style.curlRadiusM > 0.0F)
        segments = style.turns * kPointsPerTurn / std::max(1.0F - style.braidStart, 0.1F);
    // A wisp swings twice or more through the braid while it swings once along its width.
    if (style.braid != BraidKind::None)
        segments = std::max(segments, style.braidTurns * std::max(lacingOf(style.braid).swings, 2.0F) * kPointsPerTurn /
                                          std::max(1.0F - style.braidStart, 0.1F));
    if (style.frizzM > 0.0F)
        segments = std::max(segments, frizzOf(style).waveRad / kFullTurn * kFrizzFiner * kPointsPerTurn);
    return static_cast<int>(std::ceil(std::clamp(segments, 0.0F, coils != nullptr ? kMostOfCoils : kMostSegments)));
}

int segmentsOf(const StrandStyle& style, int nodes, const CurlSettings* coils)
{
    const int most = static_cast<int>(coils != nullptr ? kMostOfCoils : kMostSegments);
    return std::clamp(std::max((nodes - 1) * 2, curveSegmentsOf(style, coils)), 1, most);
}

glm::vec3 frameTangentHd(const Groom& groom, std::uint32_t slot)
{
    const RootSet& roots = *groom.roots;
    const auto& chunk = groom.chunks[chunkOf(slot)];
    const std::uint32_t centre = chunk ? chunk->braidCentre[inChunk(slot)] : kNoCentre;
    if (chunk && !chunk->cornrows.empty() && chunk->cornrows[inChunk(slot)].end > 0.0F)
        return chunk->cornrows[inChunk(slot)].sideHd;
    if (coilsOf(groom.settings) != nullptr && chunk && centre == kNoCentre) {
        // An S lies on the skin beside the hair, and neighbours' frames are turned alike whatever the map's uv.
        const StrandBlocks layout = groom.blocks();
        const glm::vec3 onward = layout.node(chunk->restPositions, inChunk(slot), 1) - roots.positionHd[slot];
        const glm::vec3 side = glm::cross(roots.normalHd[slot], onward);
        if (glm::dot(side, side) > kUpright * glm::dot(onward, onward))
            return glm::normalize(side);
    }
    return roots.tangentHd[centre == kNoCentre ? slot : roots.basisSlot[centre]];
}

void evaluateStrand(std::span<const glm::vec3> skeletonHd, glm::vec3 rootTangentHd, const StrandStyle& style,
                    int segments, std::vector<glm::vec3>& pointsHd, const CurlSettings* coils)
{
    pointsHd.clear();
    if (skeletonHd.size() < 2 || segments < 1)
        return;
    const std::size_t last = skeletonHd.size() - 1;
    const bool isCurled = style.turns > 0.0F && style.curlRadiusM > 0.0F;
    const bool isBraided = style.braid != BraidKind::None && style.braidStart < 1.0F;
    SkeletonWalk course(skeletonHd, style.isTaut());
    const auto fractionOf = [segments](int j) { return static_cast<float>(j) / static_cast<float>(segments); };
    if (!isCurled && !isBraided && !(style.frizzM > 0.0F)) {
        for (int j = 0; j <= segments; ++j) {
            course.goTo(fractionOf(j));
            pointsHd.push_back(course.position());
        }
        return;
    }
    const of_floats::Frizz frizz = of_floats::frizzOf(style.frizzM, style.lengthM);
    glm::vec3 lastPoint = skeletonHd[0];
    // Only where the skeleton has no direction at all.
    glm::vec3 lastTangent = of_floats::across(glm::vec3(0.0F), rootTangentHd);
    glm::vec3 reference(0.0F);
    const auto shared = static_cast<std::size_t>(std::lround(style.braidStart * static_cast<float>(last))) + 1;
    bool isFramed = !isBraided || shared > last; // As it will be.
    for (int j = 0; j <= segments; ++j) {
        const float s = fractionOf(j);
        course.goTo(s);
        const float u = course.u();
        const glm::vec3 position = course.position();
        const glm::vec3 derivative = course.derivative();
        const glm::vec3 tangent = of_floats::tangentOf(derivative, lastTangent);
        if (!isFramed && u >= static_cast<float>(shared)) {
            isFramed = true;
            const of_floats::Span from = spanOf(skeletonHd, std::min(shared, last - 1), style.isTaut());
            const float end = shared < last ? 0.0F : 1.0F;
            lastPoint = of_floats::positionAt(from, end);
            lastTangent = of_floats::tangentOf(of_floats::derivativeAt(from, end), lastTangent);
            reference = of_floats::across(rootTangentHd, lastTangent);
        }
        reference = j == 0 ? of_floats::across(rootTangentHd, tangent)
                           : of_floats::carried(reference, lastPoint, lastTangent, position, tangent);
        lastPoint = position;
        lastTangent = tangent;

        glm::vec3 point = position;
        const float gathered = 1.0F + u - style.braidStart * static_cast<float>(last);
        if (isBraided && gathered > 0.0F) {
            const glm::vec3 first =
                u < static_cast<float>(shared) ? of_floats::across(rootTangentHd, tangent) : reference;
            const float braidM =
                of_floats::braidLength(glm::length(derivative), static_cast<float>(last), style.braidStart);
            const float q = of_floats::braidFraction(s, style.braidStart);
            const glm::vec3 offset = braidedOffset(style, q, braidM) * of_floats::gatheredPart(gathered);
            point += first * offset.x + tangent * offset.y + glm::cross(first, tangent) * offset.z;
        } else if (isCurled && coils != nullptr) {
            const glm::vec3 offset = coilOffset(style, *coils, of_floats::curledFraction(s, style.braidStart));
            point += reference * offset.x + glm::cross(tangent, reference) * offset.y;
        } else if (isCurled) {
            const float curled = of_floats::curledFraction(s, style.braidStart);
            const glm::vec3 offset = curlOffset(of_floats::curlAngle(style.phase, style.turns, curled)) *
                                     of_floats::curlRadius(style.curlRadiusM, curled);
            point += reference * offset.x + glm::cross(tangent, reference) * offset.y + tangent * offset.z;
        }
        if (style.frizzM > 0.0F) {
            const glm::vec3 offset = of_floats::frizzOffset(frizz, style.variation, s);
            point += reference * offset.x + glm::cross(tangent, reference) * offset.y;
        }
        pointsHd.push_back(point);
    }
}

} // namespace hairpaint::sim
