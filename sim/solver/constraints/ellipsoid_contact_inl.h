// Contact with ellipsoids: a node inside one is projected to its surface, to first order along the gradient of the
// ellipsoid's quadratic form (position-based, Jakobsen 2001).
#if defined(HAIRPAINT_SIM_ELLIPSOID_CONTACT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_SIM_ELLIPSOID_CONTACT_INL_H_
#undef HAIRPAINT_SIM_ELLIPSOID_CONTACT_INL_H_
#else
#define HAIRPAINT_SIM_ELLIPSOID_CONTACT_INL_H_
#endif

#include "sim/solver/constraints/contact_inl.h"
#include "sim/solver/solver_layout.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

/// Moves p out of the ellipsoid, scaled so that its squared radius is `scale2`, by at most `furthest` metres. Returns
/// whether any lane was inside.
HWY_INLINE bool pushOut(const Collider& collider, Lanes scale2, Lanes furthest, Lanes3& p, Contact& contact)
{
    const auto& squares = collider.squares;
    const auto& mixed = collider.mixed;
    const Lanes3 q = p - everyLane(collider.centre);
    const Lanes3 square{q.x * squares[0], q.y * squares[1], q.z * squares[2]};
    Lanes3 across{0.0F, 0.0F, 0.0F}; // What comes of the products of two axes.
    Lanes r2 = dot(q, square);
    if (!collider.aligned()) {
        const Lanes zAcrossY = q.z * mixed[2];
        across = {q.y * mixed[0] + q.z * mixed[1], q.x * mixed[0] + zAcrossY, q.x * mixed[1] + q.y * mixed[2]};
        r2 = dot(q, {square.x + across.x, square.y + zAcrossY, square.z});
    }
    const Yes inside = r2 < scale2;
    if (!any(inside))
        return false;
    // Half the gradient of r2.
    const Lanes3 g = square + across * 0.5F;
    const Lanes g2 = most(dot(g, g), 1e-8F);
    const Lanes inverse = Lanes(1.0F) / g2;
    // The change of the radius r over a metre is |g|/r, and (scale - r) r is sqrt(scale2 r2) - r2.
    const Lanes square2 = most(r2, 1e-8F);
    Lanes stride = (root(scale2 * square2) - square2) * inverse;
    Lanes depth2 = stride * stride * g2;
    const Yes far = inside & (depth2 > furthest * furthest);
    if (HWY_UNLIKELY(any(far))) {
        stride = select(far, furthest * root(inverse), stride);
        depth2 = select(far, furthest * furthest, depth2);
    }
    p = select(inside, p + g * stride, p);
    touch(contact, inside, g, inverse, depth2);
    return true;
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
