// Points of as many hairs as there are lanes, out of the skin.
#if defined(HAIRPAINT_SIM_SKIN_DISTANCE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_SIM_SKIN_DISTANCE_INL_H_
#undef HAIRPAINT_SIM_SKIN_DISTANCE_INL_H_
#else
#define HAIRPAINT_SIM_SKIN_DISTANCE_INL_H_
#endif

#include "sim/groom/skin_distance.h"
#include "sim/skin/skin_field_inl.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

/// Without a grid: one lane after the other.
HWY_INLINE Lanes3 pushedOutOneByOne(const SkinDistance& distance, const Lanes3& point, Lanes clearance,
                                    const glm::vec3& centreHd)
{
    HWY_ALIGN float at[3 * kLanes];
    HWY_ALIGN float clearances[kLanes];
    stored3(point, at);
    stored(clearance, clearances);
    for (std::size_t i = 0; i < hn::Lanes(Tag()); ++i)
        StrandBlocks::store(at + i, distance.pushedOut(StrandBlocks::load(at + i), clearances[i], centreHd));
    return loaded3(at);
}

/// As SkinDistance::pushedOut(), operation by operation.
HWY_INLINE Lanes3 pushedOut(const SkinDistance& distance, Lanes3 point, Lanes clearance, const glm::vec3& centreHd)
{
    if (distance.field().pairs == nullptr)
        return pushedOutOneByOne(distance, point, clearance, centreHd);
    Yes moves = !noLane();
    for (int stride = 0; stride < SkinDistance::kMostStrides; ++stride) {
        const FieldSample sample = sampleField(distance.field(), point);
        moves = moves & (sample.inGrid & (sample.distanceM < clearance));
        if (!any(moves))
            break;
        const Lanes slope2 = dot(sample.gradient, sample.gradient);
        const Yes slopes = moves & (slope2 >= SkinDistance::kLeastSlope2);
        point = select(slopes, point + sample.gradient * ((clearance - sample.distanceM) / slope2), point);
        moves = moves & (!slopes);
        if (!any(moves))
            break;
        // Deeper than distances are known.
        const Lanes3 outward = point - tripleOf<Lanes>(centreHd);
        const Lanes length = root(dot(outward, outward));
        moves = moves & (length > 1e-6F);
        point = select(moves, point + outward * (Lanes(DistanceGrid::kReachM) / length), point);
    }
    return point;
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
