// Following the head: each step a node loses a fraction of its motion against the head, where gel holds its shape and,
// near its root, where the hair around it does.
#if defined(HAIRPAINT_SIM_HEAD_FOLLOWING_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_SIM_HEAD_FOLLOWING_INL_H_
#undef HAIRPAINT_SIM_HEAD_FOLLOWING_INL_H_
#else
#define HAIRPAINT_SIM_HEAD_FOLLOWING_INL_H_
#endif

#include "sim/base/lanes_inl.h"
#include "sim/solver/solver_layout.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

/// The fraction of a node's motion against the head that is left.
HWY_INLINE Lanes keptAgainstHead(const GroupGains& gains, const float* HWY_RESTRICT lanes, int node)
{
    return loaded(lanes + kHoldKeep * kLanes) * gains.rootKeep[static_cast<std::size_t>(node)];
}

HWY_INLINE Lanes3 followingHead(const Lanes3& velocity, const Lanes3& onHead, Lanes keep)
{
    return velocity - onHead * (1.0F - keep);
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
