// Small vector algebra of the kernels; compiled once for each instruction set. Mul, Add, Div and Sqrt only, so that
// every instruction set gives the same bytes; and what one lane needs never changes a bit of another, so that a strand
// does not depend on its neighbours in the block.
#if defined(HAIRPAINT_SIM_VEC3_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_SIM_VEC3_INL_H_
#undef HAIRPAINT_SIM_VEC3_INL_H_
#else
#define HAIRPAINT_SIM_VEC3_INL_H_
#endif

#include "sim/base/strand_blocks.h"

#include <array>
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

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
