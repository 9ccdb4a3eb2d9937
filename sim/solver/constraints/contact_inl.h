// What a node touched: the record that every constraint of contact writes and friction reads.
#if defined(HAIRPAINT_SIM_CONTACT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_SIM_CONTACT_INL_H_
#undef HAIRPAINT_SIM_CONTACT_INL_H_
#else
#define HAIRPAINT_SIM_CONTACT_INL_H_
#endif

#include "sim/base/lanes_inl.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

/// Where a node touched a solid or the skin: outward normal (not unit), the inverse of its squared length, and the
/// squared depth it had.
struct Contact
{
    Lanes3 normal;
    Lanes inverseNormal2;
    Lanes depth2;
    Yes touched;
    Yes latest; ///< The lanes of the latest touch; valid once there was one.
};

HWY_INLINE Contact noContact()
{
    return {{0.0F, 0.0F, 0.0F}, 1.0F, 0.0F, noLane(), noLane()};
}

HWY_INLINE void touch(Contact& contact, Yes where, const Lanes3& normal, Lanes inverseNormal2, Lanes depth2)
{
    contact.normal = select(where, normal, contact.normal);
    contact.inverseNormal2 = select(where, inverseNormal2, contact.inverseNormal2);
    contact.depth2 = select(where, depth2, contact.depth2);
    contact.touched = contact.touched | where;
    contact.latest = where;
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
