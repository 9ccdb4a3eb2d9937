// Numbers and vectors with operators that kernels and formulas are written in: lane_numbers_inl.h, quad_inl.h,
// lane_functions_inl.h, and here vectors of three.
#if defined(HAIRPAINT_SIM_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_SIM_LANES_INL_H_
#undef HAIRPAINT_SIM_LANES_INL_H_
#else
#define HAIRPAINT_SIM_LANES_INL_H_
#endif

#include "sim/base/lane_functions_inl.h"
#include "sim/base/lane_numbers_inl.h"
#include "sim/base/quad_inl.h"

#include <array>
#include <hwy/highway.h>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

template<class F>
struct Triple
{
    F x, y, z;
};
template<class F>
HWY_INLINE Triple<F> operator+(const Triple<F>& a, const Triple<F>& b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template<class F>
HWY_INLINE Triple<F> operator-(const Triple<F>& a, const Triple<F>& b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template<class F>
HWY_INLINE Triple<F> operator*(const Triple<F>& a, std::type_identity_t<F> s)
{
    return {a.x * s, a.y * s, a.z * s};
}
template<class F>
HWY_INLINE Triple<F> operator*(const Triple<F>& a, const Triple<F>& b)
{
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}
template<class F>
HWY_INLINE F dot(const Triple<F>& a, const Triple<F>& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template<class F>
HWY_INLINE Triple<F> cross(const Triple<F>& a, const Triple<F>& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template<class F>
HWY_INLINE Triple<F> unit(const Triple<F>& a)
{
    return a * (F(1.0F) / root(most(dot(a, a), F(1e-20F))));
}
template<class B, class F>
HWY_INLINE Triple<F> select(B yes, const Triple<F>& a, const Triple<F>& b)
{
    return {select(yes, a.x, b.x), select(yes, a.y, b.y), select(yes, a.z, b.z)};
}
/// The same in every lane.
template<class F, class V>
HWY_INLINE Triple<F> tripleOf(const V& v)
{
    return {F(v.x), F(v.y), F(v.z)};
}

using Lanes3 = Triple<Lanes>;

HWY_INLINE Lanes3 everyLane(const std::array<float, 3>& v)
{
    return {v[0], v[1], v[2]};
}
/// Rows of kLanes floats, one after the other.
HWY_INLINE Lanes3 loaded3(const float* from)
{
    return {loaded(from), loaded(from + kLanes), loaded(from + 2 * kLanes)};
}
HWY_INLINE void stored3(const Lanes3& v, float* to)
{
    stored(v.x, to);
    stored(v.y, to + kLanes);
    stored(v.z, to + 2 * kLanes);
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
