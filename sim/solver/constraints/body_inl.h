// Hair against hair: friction drags a node along with the hair around, and a node in hair that is too dense does not
// move further into it but leaves slowly, as from an inelastic contact. What is around comes from HairBody's grid.
#if defined(HAIRPAINT_SIM_BODY_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_SIM_BODY_INL_H_
#undef HAIRPAINT_SIM_BODY_INL_H_
#else
#define HAIRPAINT_SIM_BODY_INL_H_
#endif

#include "sim/base/lanes_inl.h"
#include "sim/solver/body_kernel.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

/// A node's displacement of a step among hair; `body`: its kBodyRows.
HWY_INLINE Lanes3 amongHair(const float* HWY_RESTRICT body, const Lanes3& displacement)
{
    const Lanes3 dragged = displacement + loaded3(body);
    const Lanes3 outward = loaded3(body + 3 * kLanes);
    const Lanes contact2 = dot(outward, outward);
    if (!any(contact2 > 0.0F))
        return dragged;
    // Along outward/contact it shall move by contact kBodyLeaveM; as much of what is missing as the contact is strong.
    const Lanes missing = contact2 * kBodyLeaveM - dot(dragged, outward);
    return dragged + outward * most(missing / root(most(contact2, 1e-12F)), 0.0F);
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
