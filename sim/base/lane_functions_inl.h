// Functions of floats and of lanes alike, out of operations that round alike everywhere: errors stand at each.
#if defined(HAIRPAINT_SIM_LANE_FUNCTIONS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_SIM_LANE_FUNCTIONS_INL_H_
#undef HAIRPAINT_SIM_LANE_FUNCTIONS_INL_H_
#else
#define HAIRPAINT_SIM_LANE_FUNCTIONS_INL_H_
#endif

#include "sim/base/lane_numbers_inl.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

template<class F>
HWY_INLINE F clamped(F x, float low, float high)
{
    return least(most(x, F(low)), F(high));
}
template<class F>
HWY_INLINE F mixed(F a, F b, F t)
{
    return a + (b - a) * t;
}
template<class F>
HWY_INLINE F smoothStep(float from, float to, F x)
{
    const F t = clamped((x - F(from)) * F(1.0F / (to - from)), 0.0F, 1.0F);
    return t * t * (F(3.0F) - F(2.0F) * t);
}
/// 2^x for x in -126..127, relative error under 2e-7 times x.
template<class F>
HWY_INLINE F exp2Of(F x)
{
    const F bounded = clamped(x, -125.0F, 126.0F);
    const F whole = floored(bounded + F(0.5F));
    const F r = (bounded - whole) * F(0.69314718F);
    const F series =
        F(1.0F) +
        r * (F(1.0F) + r * (F(0.5F) + r * (F(1.0F / 6.0F) +
                                           r * (F(1.0F / 24.0F) + r * (F(1.0F / 120.0F) + r * F(1.0F / 720.0F))))));
    return series * powerOfTwo(whole);
}
/// Exponent and mantissa in 1..2 of a positive normal number.
HWY_INLINE Lanes exponentOf(Lanes x, Lanes& mantissa)
{
    const IntTag di;
    const Ints bits = hn::BitCast(di, x.v);
    mantissa = Lanes(hn::BitCast(Tag(), hn::Or(hn::And(bits, hn::Set(di, 0x007FFFFF)), hn::Set(di, 0x3F800000))));
    return Lanes(hn::ConvertTo(Tag(), hn::Sub(hn::ShiftRight<23>(bits), hn::Set(di, 127))));
}
HWY_INLINE float exponentOf(float x, float& mantissa)
{
    const auto bits = std::bit_cast<std::uint32_t>(x);
    mantissa = std::bit_cast<float>((bits & 0x007FFFFFU) | 0x3F800000U);
    return static_cast<float>(static_cast<std::int32_t>(bits >> 23U) - 127);
}
/// Base-2 logarithm of a positive normal number, absolute error under 1e-5.
template<class F>
HWY_INLINE F log2Of(F x)
{
    F m;
    const F whole = exponentOf(x, m);
    // log2 of 1..2 by the series of the inverse hyperbolic tangent around its middle.
    const F t = (m - F(1.41421356F)) / (m + F(1.41421356F));
    const F s = t * t;
    const F log = t * (F(2.88539008F) + s * (F(0.96179669F) + s * (F(0.57707802F) + s * F(0.41219859F))));
    return whole + F(0.5F) + log;
}
/// x^power for x from 0 on.
template<class F>
HWY_INLINE F powerOf(F x, F power)
{
    return exp2Of(log2Of(most(x, F(1e-30F))) * power);
}
/// Absolute error under 1e-5 for |x| < 200.
template<class F>
HWY_INLINE F sinOf(F x)
{
    const F turns = floored(x * F(0.318309886F) + F(0.5F)); // Number of half turns.
    F r = x - turns * F(3.140625F);
    r = r - turns * F(9.67653589793e-4F);
    const F s = r * r;
    const F value =
        r *
        (F(1.0F) + s * (F(-1.0F / 6.0F) + s * (F(1.0F / 120.0F) + s * (F(-1.0F / 5040.0F) + s * F(1.0F / 362880.0F)))));
    const F half = turns * F(0.5F);
    const F odd = half - floored(half); // 0 or 1/2.
    return value * (F(1.0F) - F(4.0F) * odd);
}
template<class F>
HWY_INLINE F cosOf(F x)
{
    return sinOf(x + F(1.57079633F));
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
