// Numbers and vectors with operators that kernels and formulas are written in: a float, or as many as a vector of the
// instruction set holds. Compiled once for each instruction set; Mul, Add, Div, Sqrt and what is exact only, so that
// all of them give the same bytes. No lane changes a bit of another: a strand does not depend on its neighbours in the
// block.
#if defined(HAIRPAINT_SIM_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_SIM_LANES_INL_H_
#undef HAIRPAINT_SIM_LANES_INL_H_
#else
#define HAIRPAINT_SIM_LANES_INL_H_
#endif

#include "sim/base/strand_blocks.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <hwy/highway.h>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<float, kLanes>;
using IntTag = hn::Rebind<std::int32_t, Tag>;
using Ints = hn::Vec<IntTag>;

/// Yes or no for each lane.
struct Yes
{
    hn::Mask<Tag> m;
};

/// Floats, one a lane.
struct Lanes
{
    hn::Vec<Tag> v;
    Lanes() = default;
    HWY_INLINE Lanes(float f) : v(hn::Set(Tag(), f)) {}
    HWY_INLINE explicit Lanes(hn::Vec<Tag> vector) : v(vector) {}
};

HWY_INLINE Lanes operator+(Lanes a, Lanes b)
{
    return Lanes(hn::Add(a.v, b.v));
}
HWY_INLINE Lanes operator-(Lanes a, Lanes b)
{
    return Lanes(hn::Sub(a.v, b.v));
}
HWY_INLINE Lanes operator*(Lanes a, Lanes b)
{
    return Lanes(hn::Mul(a.v, b.v));
}
HWY_INLINE Lanes operator/(Lanes a, Lanes b)
{
    return Lanes(hn::Div(a.v, b.v));
}
HWY_INLINE Yes operator<(Lanes a, Lanes b)
{
    return {hn::Lt(a.v, b.v)};
}
HWY_INLINE Yes operator>(Lanes a, Lanes b)
{
    return {hn::Gt(a.v, b.v)};
}
HWY_INLINE Yes operator<=(Lanes a, Lanes b)
{
    return {hn::Le(a.v, b.v)};
}
HWY_INLINE Yes operator>=(Lanes a, Lanes b)
{
    return {hn::Ge(a.v, b.v)};
}
HWY_INLINE Yes operator==(Lanes a, Lanes b)
{
    return {hn::Eq(a.v, b.v)};
}
HWY_INLINE Yes operator!=(Lanes a, Lanes b)
{
    return {hn::Ne(a.v, b.v)};
}
HWY_INLINE Yes operator!(Yes a)
{
    return {hn::Not(a.m)};
}
HWY_INLINE Yes operator&(Yes a, Yes b)
{
    return {hn::And(a.m, b.m)};
}
HWY_INLINE Yes operator|(Yes a, Yes b)
{
    return {hn::Or(a.m, b.m)};
}
HWY_INLINE Lanes least(Lanes a, Lanes b)
{
    return Lanes(hn::Min(a.v, b.v));
}
HWY_INLINE Lanes most(Lanes a, Lanes b)
{
    return Lanes(hn::Max(a.v, b.v));
}
HWY_INLINE Lanes root(Lanes a)
{
    return Lanes(hn::Sqrt(a.v));
}
HWY_INLINE Lanes floored(Lanes a)
{
    return Lanes(hn::Floor(a.v));
}
HWY_INLINE Lanes magnitude(Lanes a)
{
    return Lanes(hn::Abs(a.v));
}
/// The nearest whole number; halves go to the even one.
HWY_INLINE Lanes rounded(Lanes a)
{
    return Lanes(hn::Round(a.v));
}
HWY_INLINE Lanes select(Yes yes, Lanes a, Lanes b)
{
    return Lanes(hn::IfThenElse(yes.m, a.v, b.v));
}
/// 0 elsewhere.
HWY_INLINE Lanes onlyWhere(Yes yes, Lanes a)
{
    return Lanes(hn::IfThenElseZero(yes.m, a.v));
}
HWY_INLINE Yes noLane()
{
    return {hn::MaskFromVec(hn::Zero(Tag()))};
}
/// The whole number toward 0.
HWY_INLINE Ints asInts(Lanes a)
{
    return hn::ConvertTo(IntTag(), a.v);
}
HWY_INLINE Lanes asFloats(Ints a)
{
    return Lanes(hn::ConvertTo(Tag(), a));
}
/// 2 to the power of a whole number in -126..127.
HWY_INLINE Lanes powerOfTwo(Lanes whole)
{
    const IntTag di;
    const Ints exponent = hn::Add(hn::ConvertTo(di, whole.v), hn::Set(di, 127));
    return Lanes(hn::BitCast(Tag(), hn::ShiftLeft<23>(exponent)));
}
HWY_INLINE bool any(Yes yes)
{
    return !hn::AllFalse(Tag(), yes.m);
}
HWY_INLINE bool all(Yes yes)
{
    return hn::AllTrue(Tag(), yes.m);
}

HWY_INLINE bool any(bool yes)
{
    return yes;
}
HWY_INLINE float least(float a, float b)
{
    return a < b ? a : b;
}
HWY_INLINE float most(float a, float b)
{
    return a > b ? a : b;
}
HWY_INLINE float root(float a)
{
    return std::sqrt(a);
}
HWY_INLINE float floored(float a)
{
    return std::floor(a);
}
HWY_INLINE float select(bool yes, float a, float b)
{
    return yes ? a : b;
}
HWY_INLINE float powerOfTwo(float whole)
{
    return std::bit_cast<float>(static_cast<std::uint32_t>(static_cast<std::int32_t>(whole) + 127) << 23U);
}

/// Four floats, as of a colour and what goes with it; on every instruction set.
#if HWY_TARGET == HWY_SCALAR
struct Quad
{
    float v[4];
};
HWY_INLINE Quad quadOf(const float* aligned)
{
    return {{aligned[0], aligned[1], aligned[2], aligned[3]}};
}
HWY_INLINE Quad quadOf(float all)
{
    return {{all, all, all, all}};
}
HWY_INLINE void stored(const Quad& quad, float* aligned)
{
    std::copy_n(quad.v, 4, aligned);
}
HWY_INLINE Quad operator+(const Quad& a, const Quad& b)
{
    return {{a.v[0] + b.v[0], a.v[1] + b.v[1], a.v[2] + b.v[2], a.v[3] + b.v[3]}};
}
HWY_INLINE Quad operator-(const Quad& a, const Quad& b)
{
    return {{a.v[0] - b.v[0], a.v[1] - b.v[1], a.v[2] - b.v[2], a.v[3] - b.v[3]}};
}
HWY_INLINE Quad operator*(const Quad& a, const Quad& b)
{
    return {{a.v[0] * b.v[0], a.v[1] * b.v[1], a.v[2] * b.v[2], a.v[3] * b.v[3]}};
}
HWY_INLINE Quad least(const Quad& a, const Quad& b)
{
    return {{least(a.v[0], b.v[0]), least(a.v[1], b.v[1]), least(a.v[2], b.v[2]), least(a.v[3], b.v[3])}};
}
HWY_INLINE Quad most(const Quad& a, const Quad& b)
{
    return {{most(a.v[0], b.v[0]), most(a.v[1], b.v[1]), most(a.v[2], b.v[2]), most(a.v[3], b.v[3])}};
}
HWY_INLINE Quad root(const Quad& a)
{
    return {{root(a.v[0]), root(a.v[1]), root(a.v[2]), root(a.v[3])}};
}
#else
using QuadTag = hn::FixedTag<float, 4>;
struct Quad
{
    hn::Vec<QuadTag> v;
};
HWY_INLINE Quad quadOf(const float* aligned)
{
    return {hn::Load(QuadTag(), aligned)};
}
HWY_INLINE Quad quadOf(float all)
{
    return {hn::Set(QuadTag(), all)};
}
HWY_INLINE void stored(Quad quad, float* aligned)
{
    hn::Store(quad.v, QuadTag(), aligned);
}
HWY_INLINE Quad operator+(Quad a, Quad b)
{
    return {hn::Add(a.v, b.v)};
}
HWY_INLINE Quad operator-(Quad a, Quad b)
{
    return {hn::Sub(a.v, b.v)};
}
HWY_INLINE Quad operator*(Quad a, Quad b)
{
    return {hn::Mul(a.v, b.v)};
}
HWY_INLINE Quad least(Quad a, Quad b)
{
    return {hn::Min(a.v, b.v)};
}
HWY_INLINE Quad most(Quad a, Quad b)
{
    return {hn::Max(a.v, b.v)};
}
HWY_INLINE Quad root(Quad a)
{
    return {hn::Sqrt(a.v)};
}
#endif

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
/// Of a positive normal number, within 1e-5.
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
    const F turns = floored(x * F(0.318309886F) + F(0.5F)); // Half turns.
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

HWY_INLINE Lanes loaded(const float* from)
{
    return Lanes(hn::LoadU(Tag(), from));
}
HWY_INLINE void stored(Lanes lanes, float* to)
{
    hn::StoreU(lanes.v, Tag(), to);
}
/// from[index] of each lane.
HWY_INLINE Lanes gatheredFrom(const float* from, Ints index)
{
    return Lanes(hn::GatherIndex(Tag(), from, index));
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
