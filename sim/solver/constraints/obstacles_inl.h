// What a node must stay out of: first the solids, one after the other, then the skin. The later wins.
#if defined(HAIRPAINT_SIM_OBSTACLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_SIM_OBSTACLES_INL_H_
#undef HAIRPAINT_SIM_OBSTACLES_INL_H_
#else
#define HAIRPAINT_SIM_OBSTACLES_INL_H_
#endif

#include "sim/solver/constraints/neck_contact_inl.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

/// A node leaves a solid or the skin by at most this much in a step, m.
constexpr float kFastestLeaveM = 0.02F;

/// A node and what it must stay out of.
struct Obstacles
{
    const ColliderSet& colliders;
    const NeckTurn& neck;
    const float* HWY_RESTRICT lanes;
    Lanes clearance; ///< From the skin, m.
    bool first;      ///< Node of the strand.
    Lanes3 parent;
};

/// Keeps a node outside every solid, and it and its segment outside the skin; true where any lane was inside one.
/// `ofSkin`: the lanes that were inside the skin.
HWY_INLINE bool collide(const Obstacles& obstacles, Lanes3& p, Contact& contact, Yes& ofSkin)
{
    const ColliderSet& colliders = obstacles.colliders;
    bool touches = false;
    for (int c = 0; c < colliders.count; ++c)
        touches |= pushOut(colliders.items[static_cast<std::size_t>(c)], obstacles.neck,
                           loaded(obstacles.lanes + (kScale + c) * kLanes), kFastestLeaveM, p, contact);
    if (colliders.skin.pairs != nullptr &&
        pushSegmentOutOfSkin(colliders.skin, obstacles.neck, obstacles.clearance, kFastestLeaveM, obstacles.first,
                             obstacles.parent, p, contact)) {
        ofSkin = contact.latest;
        touches = true;
    }
    return touches;
}

/// The same for a node that was pushed out and then brought to its length: out of the skin again where it was in it,
/// and of the solids where they are all there is.
HWY_INLINE bool collideAgain(const Obstacles& obstacles, Lanes3& p, Contact& contact, Yes ofSkin)
{
    if (obstacles.colliders.skin.pairs == nullptr)
        return collide(obstacles, p, contact, ofSkin);
    if (!any(ofSkin))
        return false;
    return pushSegmentOutOfSkin(obstacles.colliders.skin, obstacles.neck,
                                select(ofSkin, obstacles.clearance, -kUnwanted), kFastestLeaveM, obstacles.first,
                                obstacles.parent, p, contact);
}

/// How far the strand's girth keeps a node from the skin, m.
HWY_INLINE Lanes clearanceOf(const float* HWY_RESTRICT lanes, Lanes length, int node)
{
    const Lanes eased = length * (kGirthSlope * static_cast<float>(node));
    return least(loaded(lanes + (node == 1 ? kGirthFirst : kGirth) * kLanes), eased) + kSkinClearanceM;
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
