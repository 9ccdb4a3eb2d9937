// Nearest points of two segments (after Eberly 2015).
#include "sim/solver/braid_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/solver/braid_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include "sim/base/lanes_inl.h"
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

/// The same of the nodes behind it.
HWY_INLINE Lanes3 gathered3(const BraidNodes& nodes, Ints index, std::size_t behind)
{
    return {gatheredFrom(nodes.x + behind, index), gatheredFrom(nodes.y + behind, index),
            gatheredFrom(nodes.z + behind, index)};
}

void FindNearestPoints(const BraidNodes& nodes, const SegmentPairs& pairs, SegmentsApart& apart, std::size_t count)
{
    constexpr float kParallel = 0.02F; // Squared sine of the angle at which half is decided by what is beside.
    constexpr float kLeast2 = 1e-12F;
    for (std::size_t i = 0; i < count; i += hn::Lanes(Tag())) {
        const Ints first = hn::Load(IntTag(), pairs.first + i);
        const Ints second = hn::Load(IntTag(), pairs.second + i);
        const Lanes3 a = gathered3(nodes, first, 0);
        const Lanes3 b = gathered3(nodes, second, 0);
        const Lanes3 alongA = gathered3(nodes, first, 1) - a;
        const Lanes3 alongB = gathered3(nodes, second, 1) - b;
        const Lanes3 between = a - b;
        const Lanes aa = most(dot(alongA, alongA), kLeast2);
        const Lanes bb = most(dot(alongB, alongB), kLeast2);
        const Lanes ab = dot(alongA, alongB);
        const Lanes toA = dot(alongA, between);
        const Lanes toB = dot(alongB, between);
        const Lanes begin = clamped((toA * -1.0F) / aa, 0.0F, 1.0F);
        const Lanes end = clamped((ab - toA) / aa, 0.0F, 1.0F);
        const Lanes pull = aa * bb * kParallel;
        const Lanes wide = most(aa * bb - ab * ab, 0.0F);
        const Lanes guess = clamped((ab * toB - toA * bb + pull * ((begin + end) * 0.5F)) / (wide + pull), 0.0F, 1.0F);
        const Lanes t = clamped((ab * guess + toB) / bb, 0.0F, 1.0F);
        const Lanes s = clamped((ab * t - toA) / aa, 0.0F, 1.0F);
        const Lanes3 left = between + alongA * s - alongB * t;
        const Lanes radiusA = gatheredFrom(nodes.radius, first);
        const Lanes radiusB = gatheredFrom(nodes.radius, second);
        stored(s, apart.alongFirst.data() + i);
        stored(t, apart.alongSecond.data() + i);
        stored(dot(left, left), apart.distance2.data() + i);
        stored(radiusA + (gatheredFrom(nodes.radius + 1, first) - radiusA) * s + radiusB +
                   (gatheredFrom(nodes.radius + 1, second) - radiusB) * t,
               apart.clear.data() + i);
    }
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hairpaint::sim {

HWY_EXPORT(FindNearestPoints);

void findNearestPoints(const BraidNodes& nodes, const SegmentPairs& pairs, SegmentsApart& apart, std::size_t count)
{
    HWY_DYNAMIC_DISPATCH(FindNearestPoints)(nodes, pairs, apart, count);
}

} // namespace hairpaint::sim
#endif
