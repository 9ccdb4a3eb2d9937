// Hair against hair: a node in hair that is too dense does not move further into it but leaves slowly, as from an
// inelastic contact. Where that is comes from HairBody's grid, which also drags nodes along with the hair around.
#if defined(HAIRPAINT_SIM_BODY_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_SIM_BODY_INL_H_
#undef HAIRPAINT_SIM_BODY_INL_H_
#else
#define HAIRPAINT_SIM_BODY_INL_H_
#endif

#include "sim/base/lanes_inl.h"
#include "sim/solver/body_kernel.h"
#include "sim/solver/constraints/contact_inl.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

/// A node's displacement of a step among hair with which it is in `contact`, see BodyPush.
HWY_INLINE Lanes3 amongHair(const float* HWY_RESTRICT contact, const Lanes3& displacement)
{
    const Lanes3 outward = loaded3(contact);
    const Lanes strength2 = dot(outward, outward);
    if (!any(strength2 > 0.0F))
        return displacement;
    // Along outward/strength it shall move by strength kBodyLeaveM; as much of what is missing as the contact is
    // strong.
    const Lanes missing = strength2 * kBodyLeaveM - dot(displacement, outward);
    return displacement + outward * most(missing / root(most(strength2, 1e-12F)), 0.0F);
}

/// Where a node that was at `start` goes instead of p: on a shoulder, far below its root, it goes no further out to the
/// side, where its weight would draw the hair out like a tent, but as far out of the skin.
HWY_INLINE Lanes3 heldBeside(const Contact& contact, const Lanes3& root, const Lanes3& start, const Lanes3& p)
{
    constexpr float kFarBelowM = 0.08F;
    constexpr float kFacesUp2 = 0.1F;
    const Lanes3& normal = contact.normal;
    const Yes farBelow = contact.touched & (root.y - p.y > kFarBelowM);
    if (!any(farBelow))
        return p;
    const Yes onShoulder = farBelow & (normal.y > 0.0F) & (normal.y * normal.y * contact.inverseNormal2 > kFacesUp2);
    // What creeps is left to friction: a stop that yields to one side alone would never let hair come to rest.
    constexpr float kCreepsM = 3e-5F;
    const Lanes side = select(start.x > 0.0F, 1.0F, -1.0F);
    const Lanes out = (p.x - start.x) * side - kCreepsM;
    const Yes held = onShoulder & (out > 0.0F);
    if (!any(held))
        return p;
    const Lanes back = out * side;
    const Lanes rise = normal.x * back / most(normal.y * normal.y + normal.z * normal.z, 1e-12F);
    return select(held, {p.x - back, p.y + normal.y * rise, p.z + normal.z * rise}, p);
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
