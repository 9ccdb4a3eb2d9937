// Rigid motions and rotations of points, one a lane.
#if defined(HAIRPAINT_SIM_RIGID_MOTION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_SIM_RIGID_MOTION_INL_H_
#undef HAIRPAINT_SIM_RIGID_MOTION_INL_H_
#else
#define HAIRPAINT_SIM_RIGID_MOTION_INL_H_
#endif

#include "sim/base/lanes_inl.h"
#include "sim/solver/solver_layout.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

HWY_INLINE Lanes3 moved(const RigidMotion& motion, const Lanes3& p)
{
    const auto row = [&](std::size_t i) { return dot(everyLane(motion.rows[i]), p); };
    return Lanes3{row(0), row(1), row(2)} + everyLane(motion.offset);
}

/// A unit quaternion.
struct Turn
{
    Lanes3 v;
    Lanes w;
};

HWY_INLINE Lanes3 turnedBy(const Turn& q, const Lanes3& p)
{
    const Lanes3 half = cross(q.v, cross(q.v, p) + p * q.w);
    return p + (half + half);
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
