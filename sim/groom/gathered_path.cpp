// Courses over the skin, and the arc of a tail.
#include "sim/groom/gathered_path.h"

#include "sim/base/deterministic.h"
#include "sim/groom/curve_constants.h"
#include "sim/groom/unit_vector.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hairpaint::sim {

namespace {

constexpr float kLowestHairM = 0.0006F; ///< Height of the lowest hair over the skin.
constexpr float kOutOfRootM = 0.006F;   ///< Length from its root over which a hair rises to its height.
constexpr float kHalfReachM = 0.06F;    ///< Length of a course whose hair lies in the middle of the layers.
constexpr float kOwnLayer = 0.25F;      ///< Fraction of a hair's layer that is by chance.
constexpr float kTailStepM = 0.01F;
constexpr std::size_t kTailPoints = 96;
constexpr float kTailBendM = 0.06F; ///< Length from the ring within which a tail has turned down.

/// A unit vector across a unit vector.
glm::vec3 anyAcross(glm::vec3 v)
{
    const glm::vec3 axis = std::abs(v.y) < 0.9F ? glm::vec3(0.0F, 1.0F, 0.0F) : glm::vec3(1.0F, 0.0F, 0.0F);
    return unitVectorOr(axis - v * glm::dot(axis, v), glm::vec3(0.0F, 0.0F, 1.0F));
}

/// `v` turned by the least turn that takes one unit vector to another.
glm::vec3 turned(glm::vec3 v, glm::vec3 from, glm::vec3 to)
{
    const glm::vec3 sum = from + to;
    const float whole = std::max(1.0F + glm::dot(from, to), 0.1F);
    return v - sum * (glm::dot(sum, v) / whole) + to * (2.0F * glm::dot(from, v));
}

/// How much wider than the ring a tail is: it opens behind it.
float opening(float alongM)
{
    constexpr float kMost = 1.3F;
    constexpr float kHalfM = 0.07F;
    return 1.0F + kMost * alongM / (alongM + kHalfM);
}

/// The control point before a node, for the curve of taut hair as it is drawn: see beyond() and beyondBent() in
/// curve_formula.inl.
glm::vec3 nodeBefore(std::span<const glm::vec3> nodes, std::size_t node)
{
    return node > 0 ? nodes[node - 1] : (nodes[0] - nodes[1]) * 3.0F + nodes[2];
}

/// Length of the curve from one node to another, m.
float curveLengthM(std::span<const glm::vec3> nodes, std::size_t from, std::size_t to)
{
    constexpr int kParts = 4;
    float lengthM = 0.0F;
    for (std::size_t node = from; node < to; ++node) {
        const glm::vec3 p0 = nodeBefore(nodes, node);
        const glm::vec3 p1 = nodes[node];
        const glm::vec3 p2 = nodes[node + 1];
        const glm::vec3 p3 = node + 2 < nodes.size() ? nodes[node + 2] : p2 * 2.0F - p1;
        const glm::vec3 c1 = (p2 - p0) * 0.5F;
        const glm::vec3 c2 = p0 - p1 * 2.5F + p2 * 2.0F - p3 * 0.5F;
        const glm::vec3 c3 = (p3 - p0) * 0.5F + (p1 - p2) * 1.5F;
        glm::vec3 last = p1;
        for (int part = 1; part <= kParts; ++part) {
            const float t = static_cast<float>(part) / static_cast<float>(kParts);
            const glm::vec3 next = p1 + (c1 + (c2 + c3 * t) * t) * t;
            lengthM += lengthOfVector(next - last);
            last = next;
        }
    }
    return lengthM;
}

} // namespace

int ringNode(int nodes)
{
    return std::clamp((nodes + 4) / 4, 1, nodes - 3);
}

GatheredLay::GatheredLay(const Tie& tie, const TautStrings& strings, float coatM)
    : m_strings(&strings), m_tie(tie), m_coatM(coatM * (1.0F - std::clamp(tie.tightness, 0.0F, 1.0F)))
{
    m_tie.directionHd = unitVectorOr(tie.directionHd, strings.outwardHd());
    m_uHd = anyAcross(m_tie.directionHd);
    m_vHd = glm::cross(m_tie.directionHd, m_uHd);
    makeTail();
}

void GatheredLay::makeTail()
{
    const glm::vec3 down(0.0F, -1.0F, 0.0F);
    const glm::vec3 along = m_tie.directionHd;
    // The side to which it falls: where it points, and away from the head.
    const glm::vec3 outward = m_strings->outwardHd();
    const glm::vec3 side =
        unitVectorOr(glm::vec3(along.x + 0.5F * outward.x, 0.0F, along.z + 0.5F * outward.z - 1e-3F), along);
    m_tail.resize(kTailPoints);
    glm::vec3 tangent = along;
    TailPoint at{m_strings->endHd(), m_uHd, m_vHd};
    m_tail[0] = at;
    for (std::size_t i = 1; i < kTailPoints; ++i) {
        const float alongM = kTailStepM * static_cast<float>(i);
        const float t = std::min((alongM - 0.5F * kTailStepM) / kTailBendM, 1.0F);
        const float u = 1.0F - t;
        const glm::vec3 headed = unitVectorOr(along * (u * u) + side * (2.0F * u * t) + down * (t * t), down);
        glm::vec3 middle = at.middleHd + headed * kTailStepM;
        // Clear of the skin by its radius once it has left the ring.
        constexpr float kRiseM = 0.04F;
        constexpr float kMostClearM = 0.02F;
        const float clearM = std::min(m_tie.radiusM * opening(alongM), kMostClearM) * std::min(alongM / kRiseM, 1.0F);
        for (int pass = 0; pass < 2; ++pass) {
            middle = m_strings->distance().pushedOut(middle, clearM, m_strings->centreHd());
            middle = at.middleHd + unitVectorOr(middle - at.middleHd, headed) * kTailStepM;
        }
        const glm::vec3 onward = unitVectorOr(middle - at.middleHd, tangent);
        at.middleHd = middle;
        at.uHd = turned(at.uHd, tangent, onward);
        at.uHd = unitVectorOr(at.uHd - onward * glm::dot(at.uHd, onward), anyAcross(onward));
        at.vHd = glm::cross(onward, at.uHd);
        tangent = onward;
        m_tail[i] = at;
    }
}

GatheredLay::Course GatheredLay::courseOf(std::uint32_t face, glm::vec3 rootHd, float chance, bool isCore) const
{
    constexpr std::size_t kLast = kStringPoints - 1;
    Course course;
    course.isCore = isCore;
    course.string = m_strings->from(face, rootHd);
    std::array<glm::vec3, kStringPoints>& p = course.string.pointsHd;
    std::array<float, kStringPoints> toRingM{};
    for (std::size_t k = kLast; k-- > 0;)
        toRingM[k] = toRingM[k + 1] + lengthOfVector(p[k] - p[k + 1]);
    const float far2 = toRingM[0] * toRingM[0];
    course.layer =
        far2 / (far2 + kHalfReachM * kHalfReachM) * (1.0F - kOwnLayer) + std::clamp(chance, 0.0F, 1.0F) * kOwnLayer;
    if (!isCore) {
        const glm::vec3 outward = m_strings->outwardHd();
        const glm::vec3 back = unitVectorOr(p[kLast - 2] - p[kLast], outward);
        const glm::vec3 side = turned(back - outward * glm::dot(back, outward), outward, m_tie.directionHd);
        // The roots that the ring stands on come from no side.
        const float sideways = std::sqrt(glm::dot(side, side));
        const float radiusM = m_tie.radiusM * std::sqrt(course.layer) * std::min(1.0F, 0.3F + sideways);
        const glm::vec3 across = side - m_tie.directionHd * glm::dot(side, m_tie.directionHd);
        const glm::vec3 offset = unitVectorOr(across, m_uHd) * (sideways > 1e-3F ? radiusM : 0.0F);
        course.inRing = glm::vec2(glm::dot(offset, m_uHd), glm::dot(offset, m_vHd));
        constexpr float kGathersRadii = 7.0F;
        for (std::size_t k = 1; k <= kLast; ++k) {
            const float left = std::max(1.0F - toRingM[k] / (kGathersRadii * m_tie.radiusM + 1e-6F), 0.0F);
            p[k] += offset * (left * left);
        }
    }
    for (std::size_t k = 0; k < kLast; ++k) {
        course.spansM[k] = lengthOfVector(p[k + 1] - p[k]);
        course.tautM += course.spansM[k];
    }
    return course;
}

/// All of the hair goes through the ring, and so through each circle about it: the wider that is the thinner the layer.
float GatheredLay::heightM(const Course& course, float toRingM) const
{
    const float radiusM = m_tie.radiusM;
    const float thicknessM = radiusM * radiusM * 0.5F / (toRingM + radiusM);
    const float t = std::clamp(toRingM / std::max(course.tautM, 1e-6F), 0.0F, 1.0F);
    const float rises = std::min((course.tautM - toRingM) / kOutOfRootM, 1.0F);
    return kLowestHairM + (course.layer * thicknessM + m_coatM * 4.0F * t * (1.0F - t)) * rises;
}

glm::vec3 GatheredLay::onCourse(const Course& course, float fromRootM) const
{
    const std::array<glm::vec3, kStringPoints>& p = course.string.pointsHd;
    float left = fromRootM;
    glm::vec3 point = p[kStringPoints - 1];
    for (std::size_t k = 0; k + 1 < kStringPoints; ++k) {
        const float lengthM = course.spansM[k];
        if (left < lengthM) {
            point = p[k] + (p[k + 1] - p[k]) * (left / lengthM);
            break;
        }
        left -= lengthM;
    }
    return m_strings->distance().pushedOut(point, heightM(course, course.tautM - fromRootM), m_strings->centreHd());
}

glm::vec3 GatheredLay::onTail(glm::vec2 inRing, float alongM) const
{
    const float at = std::min(alongM / kTailStepM, static_cast<float>(kTailPoints - 1));
    const auto index = std::min(static_cast<std::size_t>(at), kTailPoints - 2);
    const float t = at - static_cast<float>(index);
    const TailPoint& a = m_tail[index];
    const TailPoint& b = m_tail[index + 1];
    const glm::vec2 offset = inRing * opening(alongM);
    const float beyondM = std::max(alongM - kTailStepM * static_cast<float>(kTailPoints - 1), 0.0F);
    return a.middleHd + (b.middleHd - a.middleHd) * t + (a.uHd + (b.uHd - a.uHd) * t) * offset.x +
           (a.vHd + (b.vHd - a.vHd) * t) * offset.y + glm::vec3(0.0F, -beyondM, 0.0F);
}

float GatheredLay::layTaut(const Course& course, float lengthM, std::span<glm::vec3> nodesHd) const
{
    const auto ring = static_cast<std::size_t>(ringNode(static_cast<int>(nodesHd.size())));
    nodesHd[0] = course.string.pointsHd[0];
    for (std::size_t node = 1; node < ring; ++node)
        nodesHd[node] = onCourse(course, course.tautM * static_cast<float>(node) / static_cast<float>(ring));
    nodesHd[ring] = course.string.pointsHd[kStringPoints - 1];
    const float segmentM = std::max(lengthM - course.tautM, 0.0F) / static_cast<float>(nodesHd.size() - 1 - ring);
    nodesHd[ring + 1] = onTail(course.inRing, segmentM);
    liftSpans(nodesHd);
    return curveLengthM(nodesHd, 0, ring);
}

void GatheredLay::liftSpans(std::span<glm::vec3> nodesHd) const
{
    const auto ring = static_cast<std::size_t>(ringNode(static_cast<int>(nodesHd.size())));
    for (std::size_t node = 0; node < ring; ++node) {
        const glm::vec3 middle =
            (nodesHd[node] + nodesHd[node + 1]) * 0.5625F - (nodeBefore(nodesHd, node) + nodesHd[node + 2]) * 0.0625F;
        const glm::vec3 lift = m_strings->distance().pushedOut(middle, kLowestHairM, m_strings->centreHd()) - middle;
        const bool movesBoth = node > 0 && node + 1 < ring;
        const float part = movesBoth ? 0.9F : 1.6F;
        if (node > 0)
            nodesHd[node] += lift * part;
        if (node + 1 < ring)
            nodesHd[node + 1] += lift * part;
    }
}

float GatheredLay::layTail(const Course& course, float freeM, std::span<glm::vec3> nodesHd) const
{
    const auto ring = static_cast<std::size_t>(ringNode(static_cast<int>(nodesHd.size())));
    const std::size_t spans = nodesHd.size() - 1 - ring;
    const auto layAlong = [&](float segmentM) {
        for (std::size_t node = ring + 1; node < nodesHd.size(); ++node) {
            const glm::vec3 wanted = onTail(course.inRing, segmentM * static_cast<float>(node - ring));
            nodesHd[node] = nodesHd[node - 1] + unitVectorOr(wanted - nodesHd[node - 1], m_tie.directionHd) * segmentM;
        }
    };
    const float wholeM = freeM / static_cast<float>(spans);
    layAlong(wholeM);
    if (course.isCore)
        return freeM; // Braids follow the core, so its length does not depend on the course.
    // The curve's excess over the line is taken off only in part: once the tail has fallen it bends less.
    constexpr float kCounted = 0.8F;
    const float excessM = curveLengthM(nodesHd, ring, nodesHd.size() - 1) - freeM;
    const float segmentM = std::max(wholeM - kCounted * excessM / static_cast<float>(spans), 0.9F * wholeM);
    layAlong(segmentM);
    return segmentM * static_cast<float>(spans);
}

void GatheredLay::layToward(const Course& course, float lengthM, std::span<glm::vec3> nodesHd) const
{
    nodesHd[0] = course.string.pointsHd[0];
    const auto last = static_cast<float>(nodesHd.size() - 1);
    for (std::size_t node = 1; node < nodesHd.size(); ++node)
        nodesHd[node] = onCourse(course, lengthM * static_cast<float>(node) / last);
}

void GatheredLay::layCoil(float heightM, std::span<glm::vec3> fromRingHd) const
{
    constexpr float kQuarterTurn = 0.25F * kFullTurn;
    const auto last = static_cast<float>(fromRingHd.size() - 1);
    for (std::size_t node = 0; node < fromRingHd.size(); ++node)
        fromRingHd[node] =
            m_strings->endHd() + m_tie.directionHd * (heightM * sinDet(kQuarterTurn * static_cast<float>(node) / last));
}

} // namespace hairpaint::sim
