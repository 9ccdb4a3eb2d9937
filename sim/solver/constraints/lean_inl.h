// Lean: a small push forward or back while hair that is new first falls, as a hairdresser lays it before or behind the
// shoulders. A constant acceleration a strand, added to gravity in equation 5.
#if defined(HAIRPAINT_SIM_LEAN_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_SIM_LEAN_INL_H_
#undef HAIRPAINT_SIM_LEAN_INL_H_
#else
#define HAIRPAINT_SIM_LEAN_INL_H_
#endif

#include "sim/base/lanes_inl.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

/// Displacement of a step, m: whole at the tip, none at the root, so that no hair is pushed over the face. `lanes`: at
/// the block's first row.
HWY_INLINE Lanes3 leaning(const GroupGains& gains, const float* HWY_RESTRICT lanes, int node)
{
    const float along = static_cast<float>(node) / static_cast<float>(gains.nodes - 1);
    return everyLane(gains.lean) * (loaded(lanes + kLean * kLanes) * along);
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
