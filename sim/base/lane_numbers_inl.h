// Numbers with operators: a float, or as many as a vector of the instruction set holds. Compiled once for each
// instruction set; Mul, Add, Div, Sqrt and what is exact only, so that all of them give the same bytes. No lane changes
// a bit of another: a strand does not depend on its neighbours in the block.
#if defined(HAIRPAINT_SIM_LANE_NUMBERS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_SIM_LANE_NUMBERS_INL_H_
#undef HAIRPAINT_SIM_LANE_NUMBERS_INL_H_
#else
#define HAIRPAINT_SIM_LANE_NUMBERS_INL_H_
#endif

#include "sim/base/strand_blocks.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <hwy/highway.h>

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

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
