// What a node is given in the pass from root to tip is taken from the node above it (Mueller, Kim and Chentanez 2012):
// without it a stiff, thick strand that is bent over a shoulder gains momentum in each step and swings for ever.
#if defined(HAIRPAINT_SIM_RECOIL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_SIM_RECOIL_INL_H_
#undef HAIRPAINT_SIM_RECOIL_INL_H_
#else
#define HAIRPAINT_SIM_RECOIL_INL_H_
#endif

#include "sim/base/lanes_inl.h"
#include "sim/solver/solver_layout.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

/// `given`: the displacement by which the pass brings a node to its length; `above`: where the node above it comes
/// from, its position less its velocity.
HWY_INLINE void recoil(const float* HWY_RESTRICT lanes, Yes moving, const Lanes3& given, float* HWY_RESTRICT above)
{
    const Lanes3 before = loaded3(above);
    stored3(select(moving, before + given * loaded(lanes + kRecoil * kLanes), before), above);
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
