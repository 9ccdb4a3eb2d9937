// Small vector algebra and the ellipsoid contact that both kernels share; compiled once for each instruction set.
// Mul, Add, Div and Sqrt only, so that every instruction set gives the same bytes; and what one lane needs never
// changes a bit of another, so that a strand does not depend on its neighbours in the block.
#if defined(HAIRPAINT_SIM_STRAND_KERNEL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_SIM_STRAND_KERNEL_INL_H_
#undef HAIRPAINT_SIM_STRAND_KERNEL_INL_H_
#else
#define HAIRPAINT_SIM_STRAND_KERNEL_INL_H_
#endif

#include "sim/solver/solver_layout.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template<class V>
struct Vec3
{
    V x, y, z;
};

template<class V>
HWY_INLINE Vec3<V> add(const Vec3<V>& a, const Vec3<V>& b)
{
    return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}

template<class V>
HWY_INLINE Vec3<V> sub(const Vec3<V>& a, const Vec3<V>& b)
{
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}

template<class V>
HWY_INLINE Vec3<V> scale(const Vec3<V>& a, V s)
{
    return {hn::Mul(a.x, s), hn::Mul(a.y, s), hn::Mul(a.z, s)};
}

/// a + b s
template<class V>
HWY_INLINE Vec3<V> addScaled(const Vec3<V>& a, const Vec3<V>& b, V s)
{
    return add(a, scale(b, s));
}

template<class V>
HWY_INLINE V dot(const Vec3<V>& a, const Vec3<V>& b)
{
    return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

template<class M, class V>
HWY_INLINE Vec3<V> choose(M yes, const Vec3<V>& a, const Vec3<V>& b)
{
    return {hn::IfThenElse(yes, a.x, b.x), hn::IfThenElse(yes, a.y, b.y), hn::IfThenElse(yes, a.z, b.z)};
}

template<class D>
HWY_INLINE Vec3<hn::Vec<D>> load3(D d, const float* HWY_RESTRICT from)
{
    return {hn::LoadU(d, from), hn::LoadU(d, from + kLanes), hn::LoadU(d, from + 2 * kLanes)};
}

template<class D>
HWY_INLINE void store3(D d, const Vec3<hn::Vec<D>>& v, float* HWY_RESTRICT to)
{
    hn::StoreU(v.x, d, to);
    hn::StoreU(v.y, d, to + kLanes);
    hn::StoreU(v.z, d, to + 2 * kLanes);
}

template<class D>
HWY_INLINE Vec3<hn::Vec<D>> set3(D d, const std::array<float, 3>& v)
{
    return {hn::Set(d, v[0]), hn::Set(d, v[1]), hn::Set(d, v[2])};
}

template<class D>
HWY_INLINE Vec3<hn::Vec<D>> rotated(D d, const std::array<std::array<float, 3>, 3>& rows, const Vec3<hn::Vec<D>>& p)
{
    return {dot(set3(d, rows[0]), p), dot(set3(d, rows[1]), p), dot(set3(d, rows[2]), p)};
}

template<class D>
HWY_INLINE Vec3<hn::Vec<D>> moved(D d, const RigidMotion& motion, const Vec3<hn::Vec<D>>& p)
{
    return add(rotated(d, motion.rows, p), set3(d, motion.offset));
}

/// The point at distance `length` from `parent` toward p. A point on its parent moves along `fallback` (unit).
template<class D>
HWY_INLINE Vec3<hn::Vec<D>> atLength(D d, const Vec3<hn::Vec<D>>& parent, const Vec3<hn::Vec<D>>& p, hn::Vec<D> length,
                                     const Vec3<hn::Vec<D>>& fallback)
{
    const auto tiny = hn::Set(d, 1e-16F);
    Vec3<hn::Vec<D>> edge = sub(p, parent);
    auto square = dot(edge, edge);
    const auto degenerate = hn::Not(hn::Gt(square, tiny)); // also where p is not a number
    if (HWY_UNLIKELY(!hn::AllFalse(d, degenerate))) {
        edge = choose(degenerate, fallback, edge);
        square = hn::IfThenElse(degenerate, dot(fallback, fallback), square);
    }
    return addScaled(parent, edge, hn::Div(length, hn::Sqrt(square)));
}

/// Where a node touched an ellipsoid: outward normal (not unit), its squared length, and the squared depth it had.
template<class D>
struct Contact
{
    Vec3<hn::Vec<D>> normal;
    hn::Vec<D> normal2;
    hn::Vec<D> depth2;
    hn::Mask<D> touched;
};

template<class D>
HWY_INLINE Contact<D> noContact(D d)
{
    const auto zero = hn::Zero(d);
    return {{zero, zero, zero}, hn::Set(d, 1.0F), zero, hn::MaskFromVec(zero)};
}

/// Moves p out of the ellipsoid, scaled so that its squared radius is `scale2`, to first order along the surface's
/// normal and at most `furthest` metres. Returns whether any lane was inside.
template<class D>
HWY_INLINE bool pushOut(D d, const Collider& collider, hn::Vec<D> scale2, hn::Vec<D> furthest, Vec3<hn::Vec<D>>& p,
                        Contact<D>& contact)
{
    const auto q = rotated(d, collider.rows, sub(p, set3(d, collider.centre)));
    const auto r2 = dot(q, q);
    const auto inside = hn::Lt(r2, scale2);
    if (hn::AllFalse(d, inside))
        return false;
    const auto r = hn::Sqrt(hn::Max(r2, hn::Set(d, 1e-8F)));
    // Half the gradient of |q|^2; |gradient| / r is the change of r over a metre.
    auto g = scale(set3(d, {collider.rows[0][0], collider.rows[0][1], collider.rows[0][2]}), q.x);
    g = addScaled(g, set3(d, collider.rows[1]), q.y);
    g = addScaled(g, set3(d, collider.rows[2]), q.z);
    const auto g2 = hn::Max(dot(g, g), hn::Set(d, 1e-8F));
    auto stride = hn::Div(hn::Mul(hn::Sub(hn::Sqrt(scale2), r), r), g2);
    auto depth2 = hn::Mul(hn::Mul(stride, stride), g2);
    const auto far = hn::And(inside, hn::Gt(depth2, hn::Mul(furthest, furthest)));
    if (HWY_UNLIKELY(!hn::AllFalse(d, far))) {
        stride = hn::IfThenElse(far, hn::Div(furthest, hn::Sqrt(g2)), stride);
        depth2 = hn::IfThenElse(far, hn::Mul(furthest, furthest), depth2);
    }
    p = choose(inside, addScaled(p, g, stride), p);
    contact.normal = choose(inside, g, contact.normal);
    contact.normal2 = hn::IfThenElse(inside, g2, contact.normal2);
    contact.depth2 = hn::IfThenElse(inside, depth2, contact.depth2);
    contact.touched = hn::Or(contact.touched, inside);
    return true;
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
