// Courses between the strings of vertices, nodes along them, and the arc of the tail.
#include "sim/groom/gather_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/groom/gather_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include "sim/groom/skin_distance_inl.h"
#include "sim/groom/unit_vector_inl.h"
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

constexpr float kLowestHairM = 0.0006F; ///< Height of the lowest hair over the skin.
constexpr float kOutOfRootM = 0.006F;   ///< Length from its root over which a hair rises to its height.
constexpr float kHalfReachM = 0.06F;    ///< Length of a course whose hair lies in the middle of the layers.
constexpr float kOwnLayer = 0.25F;      ///< Fraction of a hair's layer that is by chance.
constexpr float kGathersRadii = 7.0F;   ///< Distance from the ring from which on hair goes to its point of it.
constexpr std::size_t kSpans = kStringPoints - 1;
constexpr std::int32_t kTailPointFloats = 9;
static_assert(sizeof(TautString) == 3 * kStringPoints * sizeof(float));
static_assert(sizeof(TailPoint) == kTailPointFloats * sizeof(float));

HWY_INLINE Lanes3 gathered3(const float* from, Ints index)
{
    return {gatheredFrom(from, index), gatheredFrom(from + 1, index), gatheredFrom(from + 2, index)};
}

/// Courses of hairs from their roots to the ring.
struct Courses
{
    std::array<Lanes3, kStringPoints> pointsHd;
    std::array<Lanes, kSpans> spansM; ///< Distances from each of the points to the next,
    Lanes tautM;                      ///< and their sum.
    Lanes layer;                      ///< 0..1: height among the hair that goes with it.
    Lanes u, v;                       ///< Where it goes through the ring, from its middle, m.
};

/// Lays the points between the strings of the vertices around: those that pass the head on the other side are none to
/// take the mean with.
HWY_INLINE void layBetween(const GatherTask& task, std::size_t lane, Courses& courses)
{
    constexpr std::int32_t kMiddle = kStringPoints / 2;
    constexpr float kSlackM = 0.001F;
    const IntTag di;
    const float* const numbers = &task.strings->pointsHd[0].x;
    const Lanes3 root3 = {loaded(task.lanes->rootHd[0].data() + lane), loaded(task.lanes->rootHd[1].data() + lane),
                          loaded(task.lanes->rootHd[2].data() + lane)};
    std::array<Ints, 3> strings;
    std::array<Lanes3, 3> at;
    std::array<Lanes3, 3> middle;
    for (std::size_t i = 0; i < 3; ++i) {
        strings[i] = hn::LoadU(di, task.lanes->strings[i].data() + lane);
        at[i] = gathered3(numbers, strings[i]);
        middle[i] = gathered3(numbers + 3 * kMiddle, strings[i]);
    }
    const Lanes3 normal = cross(at[1] - at[0], at[2] - at[0]);
    const Lanes area2 = most(dot(normal, normal), 1e-24F);
    std::array<Lanes, 3> weights;
    std::array<Lanes3, 3> aside;
    for (std::size_t i = 0; i < 3; ++i) {
        const Lanes3& a = at[(i + 1) % 3];
        const Lanes3& b = at[(i + 2) % 3];
        weights[i] = most(dot(cross(a - root3, b - root3), normal) / area2, 0.0F);
        aside[i] = root3 - at[i];
    }
    const Yes isSecond = weights[1] > weights[0];
    const Yes isThird = weights[2] > most(weights[0], weights[1]);
    const auto ofMost = [&](const std::array<Lanes3, 3>& of) {
        return select(isThird, of[2], select(isSecond, of[1], of[0]));
    };
    const Lanes3 mostAt = ofMost(at);
    const Lanes3 mostMiddle = ofMost(middle);
    Lanes sum(0.0F);
    for (std::size_t i = 0; i < 3; ++i) {
        const Lanes apart = lengthOf(middle[i] - mostMiddle) / (lengthOf(at[i] - mostAt) + kSlackM);
        weights[i] = weights[i] * clamped(Lanes(4.0F) - apart, 0.0F, 1.0F);
        sum = sum + weights[i];
    }
    const Yes hasNone = !(sum > 0.0F);
    const Lanes one(1.0F);
    weights[0] = select(hasNone & !(isSecond | isThird), one, weights[0]);
    weights[1] = select(hasNone & isSecond & !isThird, one, weights[1]);
    weights[2] = select(hasNone & isThird, one, weights[2]);
    sum = select(hasNone, one, sum);
    for (Lanes& weight : weights)
        weight = weight / sum;
    for (std::size_t k = 0; k < kStringPoints; ++k) {
        const float left = 1.0F - static_cast<float>(k) / static_cast<float>(kSpans);
        Lanes3 point{0.0F, 0.0F, 0.0F};
        for (std::size_t i = 0; i < 3; ++i)
            point = point + (gathered3(numbers + 3 * k, strings[i]) + aside[i] * left) * weights[i];
        courses.pointsHd[k] = point;
    }
}

/// Through the hair's own point of the ring, and through the middle where it is of the core.
HWY_INLINE Courses coursesOf(const GatherTask& task, std::size_t lane)
{
    Courses courses;
    layBetween(task, lane, courses);
    std::array<Lanes3, kStringPoints>& p = courses.pointsHd;
    std::array<Lanes, kStringPoints> toRing;
    toRing[kSpans] = Lanes(0.0F);
    for (std::size_t k = kSpans; k-- > 0;)
        toRing[k] = toRing[k + 1] + lengthOf(p[k] - p[k + 1]);
    const Lanes far2 = toRing[0] * toRing[0];
    const Lanes chance = loaded(task.lanes->chance.data() + lane);
    courses.layer =
        far2 / (far2 + kHalfReachM * kHalfReachM) * (1.0F - kOwnLayer) + clamped(chance, 0.0F, 1.0F) * kOwnLayer;

    const Lanes3 outward = tripleOf<Lanes>(task.outwardHd);
    const Lanes3 direction = tripleOf<Lanes>(task.directionHd);
    const Lanes3 back = unitOr(p[kSpans - 2] - p[kSpans], outward);
    const Lanes3 flat = back - outward * dot(back, outward);
    // Turned as the skin's normal is to the ring's axis.
    const Lanes3 sum = outward + direction;
    const Lanes whole = most(Lanes(1.0F) + dot(outward, direction), 0.1F);
    const Lanes3 side = flat - sum * (dot(sum, flat) / whole) + direction * (dot(outward, flat) * 2.0F);
    // The roots that the ring stands on come from no side.
    const Lanes sideways = lengthOf(side);
    const Lanes radius = root(courses.layer) * task.radiusM * least(1.0F, sideways + 0.3F);
    const Lanes3 across = side - direction * dot(side, direction);
    const Yes hasSide = (sideways > 1e-3F) & !(loaded(task.lanes->isCore.data() + lane) > 0.0F);
    const Lanes3 u = tripleOf<Lanes>(task.uHd);
    const Lanes3 offset = unitOr(across, u) * onlyWhere(hasSide, radius);
    courses.u = dot(offset, u);
    courses.v = dot(offset, tripleOf<Lanes>(task.vHd));
    const Lanes within(kGathersRadii * task.radiusM + 1e-6F);
    for (std::size_t k = 1; k <= kSpans; ++k) {
        const Lanes left = most(Lanes(1.0F) - toRing[k] / within, 0.0F);
        p[k] = p[k] + offset * (left * left);
    }
    courses.tautM = Lanes(0.0F);
    for (std::size_t k = 0; k < kSpans; ++k) {
        courses.spansM[k] = lengthOf(p[k + 1] - p[k]);
        courses.tautM = courses.tautM + courses.spansM[k];
    }
    return courses;
}

/// All of the hair goes through the ring, and so through each circle about it: the wider that is the thinner the layer.
HWY_INLINE Lanes heightOf(const GatherTask& task, const Courses& courses, Lanes toRingM)
{
    const float radius = task.radiusM;
    const Lanes thickness = Lanes(radius * radius * 0.5F) / (toRingM + radius);
    const Lanes t = clamped(toRingM / most(courses.tautM, 1e-6F), 0.0F, 1.0F);
    const Lanes rises = least((courses.tautM - toRingM) / kOutOfRootM, 1.0F);
    return (courses.layer * thickness + t * (task.coatM * 4.0F) * (Lanes(1.0F) - t)) * rises + kLowestHairM;
}

/// The points so far from the roots, in their layers.
HWY_INLINE Lanes3 onCourse(const GatherTask& task, const Courses& courses, Lanes fromRootM)
{
    const std::array<Lanes3, kStringPoints>& p = courses.pointsHd;
    Lanes left = fromRootM;
    Lanes before(0.0F);
    Lanes span(1.0F);
    Lanes3 from = p[kSpans];
    Lanes3 to = p[kSpans];
    Yes goesOn = !noLane();
    for (std::size_t k = 0; k < kSpans; ++k) {
        const Yes ends = goesOn & (left < courses.spansM[k]);
        goesOn = goesOn & !ends;
        from = select(ends, p[k], from);
        to = select(ends, p[k + 1], to);
        before = select(ends, left, before);
        span = select(ends, courses.spansM[k], span);
        left = left - courses.spansM[k];
    }
    const Lanes3 point = from + (to - from) * (before / span);
    return pushedOut(*task.distance, point, heightOf(task, courses, courses.tautM - fromRootM), task.centreHd);
}

/// The points of the tail so far behind the ring.
HWY_INLINE Lanes3 onTail(const GatherTask& task, const Courses& courses, Lanes along)
{
    constexpr auto kLastPoint = static_cast<float>(kTailPoints - 1);
    const IntTag di;
    const Lanes at = least(along / kTailStepM, kLastPoint);
    const Ints index = hn::Min(asInts(at), hn::Set(di, static_cast<std::int32_t>(kTailPoints) - 2));
    const Lanes t = at - asFloats(index);
    const Ints first = hn::Mul(index, hn::Set(di, kTailPointFloats));
    const float* const numbers = &task.tail->middleHd.x;
    const auto row = [&](std::int32_t offset) {
        const Lanes3 from = gathered3(numbers + offset, first);
        return from + (gathered3(numbers + kTailPointFloats + offset, first) - from) * t;
    };
    const Lanes opening = along * kTailOpens / (along + kTailHalfOpenM) + 1.0F;
    const Lanes beyond = most(along - kTailStepM * kLastPoint, 0.0F);
    const Lanes3 point = row(0) + row(3) * (courses.u * opening) + row(6) * (courses.v * opening);
    return {point.x, point.y - beyond, point.z};
}

/// Nodes in memory, [nodes][3][kLanes].
class Nodes
{
public:
    explicit HWY_INLINE Nodes(float* firstHd) : m_firstHd(firstHd) {}
    [[nodiscard]] HWY_INLINE Lanes3 operator[](int node) const { return loaded3(at(node)); }
    HWY_INLINE void put(int node, const Lanes3& p) const { stored3(p, at(node)); }
    HWY_INLINE void move(int node, const Lanes3& by) const { put(node, (*this)[node] + by); }
    /// The control point before a node, for the curve of taut hair as it is drawn: see beyond() and beyondBent() in
    /// curve_formula.inl.
    [[nodiscard]] HWY_INLINE Lanes3 before(int node) const
    {
        return node > 0 ? (*this)[node - 1] : ((*this)[0] - (*this)[1]) * 3.0F + (*this)[2];
    }

private:
    [[nodiscard]] HWY_INLINE float* at(int node) const
    {
        return m_firstHd + static_cast<std::size_t>(node) * StrandBlocks::kNodeStride;
    }
    float* m_firstHd;
};

/// Length of the curve from one node to another, m; `last` is the last node there is.
HWY_INLINE Lanes curveLength(const Nodes& nodes, int from, int to, int last)
{
    constexpr int kParts = 4;
    Lanes length(0.0F);
    Lanes3 p0 = nodes.before(from);
    Lanes3 p1 = nodes[from];
    Lanes3 p2 = nodes[from + 1];
    for (int node = from; node < to; ++node) {
        const Lanes3 p3 = node + 2 <= last ? nodes[node + 2] : p2 * 2.0F - p1;
        const Lanes3 c1 = (p2 - p0) * 0.5F;
        const Lanes3 c2 = p0 - p1 * 2.5F + p2 * 2.0F - p3 * 0.5F;
        const Lanes3 c3 = (p3 - p0) * 0.5F + (p1 - p2) * 1.5F;
        Lanes3 before = p1;
        for (int part = 1; part <= kParts; ++part) {
            const float t = static_cast<float>(part) / static_cast<float>(kParts);
            const Lanes3 next = p1 + (c1 + (c2 + c3 * t) * t) * t;
            length = length + lengthOf(next - before);
            before = next;
        }
        p0 = p1;
        p1 = p2;
        p2 = p3;
    }
    return length;
}

/// Moves nodes out until the curve through them, up to the ring, is out of the skin between them, too.
HWY_INLINE void liftSpans(const GatherTask& task, const Nodes& nodes)
{
    for (int node = 0; node < task.ring; ++node) {
        const Lanes3 middle =
            (nodes[node] + nodes[node + 1]) * 0.5625F - (nodes.before(node) + nodes[node + 2]) * 0.0625F;
        const Lanes3 lift = pushedOut(*task.distance, middle, kLowestHairM, task.centreHd) - middle;
        const bool movesBoth = node > 0 && node + 1 < task.ring;
        const float part = movesBoth ? 0.9F : 1.6F;
        if (node > 0)
            nodes.move(node, lift * part);
        if (node + 1 < task.ring)
            nodes.move(node + 1, lift * part);
    }
}

/// From the root to the ring, evenly. Returns the length of the curve, m.
HWY_INLINE Lanes layTaut(const GatherTask& task, const Courses& courses, Lanes cutM, const Nodes& nodes)
{
    const auto ring = static_cast<float>(task.ring);
    const int last = task.nodes - 1;
    nodes.put(0, courses.pointsHd[0]);
    for (int node = 1; node < task.ring; ++node)
        nodes.put(node, onCourse(task, courses, courses.tautM * static_cast<float>(node) / ring));
    nodes.put(task.ring, courses.pointsHd[kSpans]);
    const Lanes segment = most(cutM - courses.tautM, 0.0F) / static_cast<float>(last - task.ring);
    nodes.put(task.ring + 1, onTail(task, courses, segment));
    liftSpans(task, nodes);
    return curveLength(nodes, 0, task.ring, last);
}

/// Behind the ring: an arc, as hair falls while the head is upright. Returns the length of the line, m.
HWY_INLINE Lanes layTail(const GatherTask& task, const Courses& courses, Lanes freeM, Yes isCore, const Nodes& nodes)
{
    const int last = task.nodes - 1;
    const auto spans = static_cast<float>(last - task.ring);
    const Lanes3 direction = tripleOf<Lanes>(task.directionHd);
    const auto layAlong = [&](Lanes segment) {
        Lanes3 parent = nodes[task.ring];
        for (int node = task.ring + 1; node <= last; ++node) {
            const Lanes3 wanted = onTail(task, courses, segment * static_cast<float>(node - task.ring));
            parent = parent + unitOr(wanted - parent, direction) * segment;
            nodes.put(node, parent);
        }
    };
    const Lanes whole = freeM / spans;
    layAlong(whole);
    // Braids follow the core, so its length does not depend on the course.
    if (all(isCore))
        return freeM;
    // The curve's excess over the line is taken off only in part: once the tail has fallen it bends less.
    constexpr float kCounted = 0.8F;
    const Lanes excess = curveLength(nodes, task.ring, last, last) - freeM;
    const Lanes segment = select(isCore, whole, most(whole - excess * kCounted / spans, whole * 0.9F));
    layAlong(segment);
    return select(isCore, freeM, segment * spans);
}

/// The first `cutM` of their courses, evenly, where they end before the ring.
HWY_INLINE void layToward(const GatherTask& task, const Courses& courses, Lanes cutM, Yes ends, const Nodes& nodes)
{
    const auto last = static_cast<float>(task.nodes - 1);
    nodes.put(0, courses.pointsHd[0]);
    for (int node = 1; node < task.nodes; ++node)
        nodes.put(node, select(ends, onCourse(task, courses, cutM * static_cast<float>(node) / last), nodes[node]));
}

/// Lanes from `lane` on.
HWY_INLINE void gatherFrom(const GatherTask& task, std::size_t lane)
{
    GatherLanes& lanes = *task.lanes;
    const Nodes nodes(task.nodesHd + lane);
    const Courses courses = coursesOf(task, lane);
    const Lanes cut = loaded(lanes.cutM.data() + lane);
    const Yes isCore = loaded(lanes.isCore.data() + lane) > 0.0F;
    Lanes taut = layTaut(task, courses, cut, nodes);
    if (!(task.leastFreeM > 0.0F))
        taut = select(cut > courses.tautM, taut, cut);
    const Lanes free = most((cut - taut) * loaded(lanes.seen.data() + lane), task.leastFreeM);
    const Yes ends = !(free > 0.0F);
    Lanes line(0.0F);
    if (!all(ends)) {
        const Lanes given = loaded(lanes.givenFreeM.data() + lane);
        line = layTail(task, courses, select(given > 0.0F, given, free), isCore, nodes);
    }
    if (any(ends))
        layToward(task, courses, cut, ends, nodes);
    stored(taut, lanes.tautM.data() + lane);
    stored(free, lanes.freeM.data() + lane);
    stored(line, lanes.lineM.data() + lane);
}

void GatherLanesOf(const GatherTask& task)
{
    for (std::size_t lane = 0; lane < kLanes; lane += hn::Lanes(Tag()))
        gatherFrom(task, lane);
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hairpaint::sim {

HWY_EXPORT(GatherLanesOf);

void gatherLanes(const GatherTask& task)
{
    HWY_DYNAMIC_DISPATCH(GatherLanesOf)(task);
}

} // namespace hairpaint::sim
#endif
