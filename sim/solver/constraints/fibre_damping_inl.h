// Damping within the fibre: bending dies away, and a strand that turns as a whole does not notice. The velocity against
// the mean of both neighbours' is the second difference along the strand, so this is Kelvin and Voigt's damping of
// bends.
#if defined(HAIRPAINT_SIM_FIBRE_DAMPING_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_SIM_FIBRE_DAMPING_INL_H_
#undef HAIRPAINT_SIM_FIBRE_DAMPING_INL_H_
#else
#define HAIRPAINT_SIM_FIBRE_DAMPING_INL_H_
#endif

#include "sim/base/lanes_inl.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

constexpr float kBendingDamping = 0.2F; ///< Fraction of the motion against the mean of both neighbours lost in a step.

HWY_INLINE Lanes3 dampedBending(const Lanes3& before, const Lanes3& velocity, const Lanes3& after)
{
    const Lanes3 unbent = (before + after) * 0.5F;
    return velocity + (unbent - velocity) * kBendingDamping;
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
