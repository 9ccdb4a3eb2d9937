// What all hair of a tie has in common: the ring's axes and the arc of the tail.
#include "sim/groom/gathered_path.h"

#include "sim/base/deterministic.h"
#include "sim/groom/curve_constants.h"
#include "sim/groom/unit_vector.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hairpaint::sim {

namespace {

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

float opening(float alongM)
{
    return 1.0F + kTailOpens * alongM / (alongM + kTailHalfOpenM);
}

} // namespace

int ringNode(int nodes)
{
    return std::clamp((nodes + 4) / 4, 1, nodes - 3);
}

GatheredLay::GatheredLay(const Tie& tie, const TautStrings& strings, float coatM) : m_strings(&strings)
{
    m_task.distance = &strings.distance();
    m_task.centreHd = strings.centreHd();
    m_task.outwardHd = strings.outwardHd();
    m_task.directionHd = unitVectorOr(tie.directionHd, strings.outwardHd());
    m_task.uHd = anyAcross(m_task.directionHd);
    m_task.vHd = glm::cross(m_task.directionHd, m_task.uHd);
    m_task.radiusM = tie.radiusM;
    m_task.coatM = coatM * (1.0F - std::clamp(tie.tightness, 0.0F, 1.0F));
    makeTail();
}

void GatheredLay::makeTail()
{
    const glm::vec3 down(0.0F, -1.0F, 0.0F);
    const glm::vec3 along = m_task.directionHd;
    // The side to which it falls: where it points, and away from the head.
    const glm::vec3 outward = m_strings->outwardHd();
    const glm::vec3 side =
        unitVectorOr(glm::vec3(along.x + 0.5F * outward.x, 0.0F, along.z + 0.5F * outward.z - 1e-3F), along);
    m_tail.resize(kTailPoints);
    glm::vec3 tangent = along;
    TailPoint at{m_strings->endHd(), m_task.uHd, m_task.vHd};
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
        const float clearM = std::min(m_task.radiusM * opening(alongM), kMostClearM) * std::min(alongM / kRiseM, 1.0F);
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

void GatheredLay::put(GatherLanes& lanes, std::size_t lane, std::uint32_t face, glm::vec3 rootHd) const
{
    constexpr std::size_t kFloats = 3 * kStringPoints;
    const std::array<std::uint32_t, 3> strings = m_strings->ofFace(face);
    for (std::size_t i = 0; i < 3; ++i) {
        lanes.rootHd.at(i)[lane] = rootHd[static_cast<int>(i)];
        lanes.strings.at(i)[lane] = static_cast<std::int32_t>(strings.at(i) * kFloats);
    }
}

void GatheredLay::lay(GatherLanes& lanes, int nodes, std::span<float> nodesHd, float leastFreeM) const
{
    GatherTask task = m_task;
    task.strings = m_strings->strings().data();
    task.tail = m_tail.data();
    task.nodes = nodes;
    task.ring = ringNode(nodes);
    task.leastFreeM = leastFreeM;
    task.lanes = &lanes;
    task.nodesHd = nodesHd.data();
    gatherLanes(task);
}

glm::vec3 GatheredLay::onCoil(float heightM, float fraction) const
{
    constexpr float kQuarterTurn = 0.25F * kFullTurn;
    return m_strings->endHd() + m_task.directionHd * (heightM * sinDet(kQuarterTurn * fraction));
}

} // namespace hairpaint::sim
