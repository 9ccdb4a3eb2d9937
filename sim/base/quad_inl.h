// Four floats, as of a colour and what goes with it, with operators; the same on every instruction set.
#if defined(HAIRPAINT_SIM_QUAD_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_SIM_QUAD_INL_H_
#undef HAIRPAINT_SIM_QUAD_INL_H_
#else
#define HAIRPAINT_SIM_QUAD_INL_H_
#endif

#include <algorithm>
#include <cmath>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

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

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
