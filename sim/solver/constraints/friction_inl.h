// Friction of Coulomb's kind in positions (as Müller et al. 2007 damp velocities at contacts): what a node moved along
// the surface is undone where it is little against how deep the node was pressed in (it sticks), and shortened
// elsewhere.
#if defined(HAIRPAINT_SIM_FRICTION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_SIM_FRICTION_INL_H_
#undef HAIRPAINT_SIM_FRICTION_INL_H_
#else
#define HAIRPAINT_SIM_FRICTION_INL_H_
#endif

#include "sim/solver/constraints/contact_inl.h"
#include "sim/solver/solver_layout.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

/// A node that was at `start` and is at p.
HWY_INLINE Lanes3 rubbed(const GroupGains& gains, const Contact& contact, const Lanes3& start, const Lanes3& p)
{
    const Lanes3 displacement = p - start;
    const Lanes3 across = contact.normal * (dot(displacement, contact.normal) * contact.inverseNormal2);
    const Lanes3 along = displacement - across;
    const Yes sticks = dot(along, along) <= contact.depth2 * gains.stickSlope2;
    const Lanes keep = select(sticks, 0.0F, gains.frictionKeep);
    return select(contact.touched, start + across + along * keep, p);
}

/// In contact nothing moves into the surface or springs off it: `velocity` without its part along the normal, of
/// `onHead`, the motion as the head sees it, of which `keep` is left.
HWY_INLINE Lanes3 sliding(const Contact& contact, const Lanes3& onHead, Lanes keep, const Lanes3& velocity)
{
    if (!any(contact.touched))
        return velocity;
    const Lanes across = dot(onHead, contact.normal) * contact.inverseNormal2;
    return select(contact.touched, velocity - contact.normal * (across * keep), velocity);
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
