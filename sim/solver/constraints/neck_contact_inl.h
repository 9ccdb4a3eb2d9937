// Contact with a bust whose shoulders do not turn with the head: what lies below the head is turned about the neck, by
// more and more of the neck's quaternion down to the shoulders.
#if defined(HAIRPAINT_SIM_NECK_CONTACT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_SIM_NECK_CONTACT_INL_H_
#undef HAIRPAINT_SIM_NECK_CONTACT_INL_H_
#else
#define HAIRPAINT_SIM_NECK_CONTACT_INL_H_
#endif

#include "sim/solver/constraints/ellipsoid_contact_inl.h"
#include "sim/solver/constraints/skin_contact_inl.h"
#include "sim/solver/rigid_motion_inl.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

/// The whole turn from the head's frame to the shoulders'.
HWY_INLINE Turn wholeTurn(const NeckTurn& neck)
{
    return {{neck.turn[0], neck.turn[1], neck.turn[2]}, neck.turn[3]};
}

/// As much of it as skin at height y takes part in.
HWY_INLINE Turn turnAt(const NeckTurn& neck, Lanes y)
{
    const Lanes one(1.0F);
    const Lanes t = clamped((neck.headY - y) * neck.perTwistM, 0.0F, 1.0F);
    const Lanes s = t * t * (3.0F - (t + t));
    const Turn whole = wholeTurn(neck);
    const Lanes3 v = whole.v * s;
    const Lanes w = (one - s) + s * whole.w;
    const Lanes perLength = one / root(dot(v, v) + w * w);
    return {v * perLength, w * perLength};
}

/// `push`, which takes p and a contact as the skin knows them, for skin that is turned by `turn` about the neck.
template<class Push>
HWY_INLINE bool pushTurned(const NeckTurn& neck, const Turn& turn, Lanes3& p, Contact& contact, const Push& push)
{
    const Lanes3 pivot = everyLane(neck.pivot);
    const Lanes3 before = turnedBy(turn, p - pivot) + pivot;
    Lanes3 out = before;
    Contact own = noContact();
    if (!push(out, own))
        return false;
    const Turn back{Lanes3{0.0F, 0.0F, 0.0F} - turn.v, turn.w};
    p = select(own.touched, p + turnedBy(back, out - before), p);
    touch(contact, own.touched, turnedBy(back, own.normal), own.inverseNormal2, own.depth2);
    return true;
}

/// pushOut() for an ellipsoid of the head or, below the neck, of the shoulders.
HWY_INLINE bool pushOut(const Collider& collider, const NeckTurn& neck, Lanes scale2, Lanes furthest, Lanes3& p,
                        Contact& contact)
{
    if (HWY_LIKELY(!neck.turned) || collider.centre[1] > neck.shouldersY)
        return pushOut(collider, scale2, furthest, p, contact);
    return pushTurned(neck, wholeTurn(neck), p, contact,
                      [&](Lanes3& turned, Contact& own) { return pushOut(collider, scale2, furthest, turned, own); });
}

/// pushOutOfSkin() for the skin of the bust.
HWY_INLINE bool pushOutOfBust(const SkinField& skin, const NeckTurn& neck, Lanes clearance, Lanes furthest, Lanes3& p,
                              Contact& contact)
{
    if (HWY_LIKELY(!neck.turned))
        return pushOutOfSkin(skin, clearance, furthest, p, contact);
    // By how much the skin there is turned depends on its own height: found from the shoulders', then again.
    const Lanes pivotY(neck.pivot[1]);
    const Lanes3 fromPivot = p - everyLane(neck.pivot);
    const Lanes whole = turnedBy(wholeTurn(neck), fromPivot).y + pivotY;
    const Lanes once = turnedBy(turnAt(neck, whole), fromPivot).y + pivotY;
    return pushTurned(neck, turnAt(neck, once), p, contact, [&](Lanes3& turned, Contact& own) {
        return pushOutOfSkin(skin, clearance, furthest, turned, own);
    });
}

/// The same for points of the segment from p's parent, which p moves by moving further; `first`: of the strand.
HWY_INLINE bool pushSegmentOutOfSkin(const SkinField& skin, const NeckTurn& neck, Lanes clearance, Lanes furthest,
                                     bool first, const Lanes3& parent, Lanes3& p, Contact& contact)
{
    bool touches = pushOutOfBust(skin, neck, clearance, furthest, p, contact);
    Yes touched = touches ? contact.latest : noLane();
    for (std::size_t i = 1; i < kSegmentParts.size() && !first; ++i) {
        const Lanes3 point = parent + (p - parent) * kSegmentParts[i];
        Lanes3 out = point;
        if (!pushOutOfBust(skin, neck, clearance, furthest, out, contact))
            continue;
        p = p + (out - point) * (1.0F / kSegmentParts[i]);
        touched = touched | contact.latest;
        touches = true;
    }
    contact.latest = touched;
    return touches;
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
