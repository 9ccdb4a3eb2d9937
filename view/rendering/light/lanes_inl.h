// The numbers that the light's formulas are written in (sim/base/lanes_inl.h), and their colours.
#if defined(HAIRPAINT_RENDERING_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_RENDERING_LANES_INL_H_
#undef HAIRPAINT_RENDERING_LANES_INL_H_
#else
#define HAIRPAINT_RENDERING_LANES_INL_H_
#endif

#include "sim/base/lanes_inl.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::rendering::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using sim::HWY_NAMESPACE::all;
using sim::HWY_NAMESPACE::any;
using sim::HWY_NAMESPACE::clamped;
using sim::HWY_NAMESPACE::cosOf;
using sim::HWY_NAMESPACE::cross;
using sim::HWY_NAMESPACE::dot;
using sim::HWY_NAMESPACE::exp2Of;
using sim::HWY_NAMESPACE::exponentOf;
using sim::HWY_NAMESPACE::floored;
using sim::HWY_NAMESPACE::Ints;
using sim::HWY_NAMESPACE::IntTag;
using sim::HWY_NAMESPACE::Lanes;
using sim::HWY_NAMESPACE::least;
using sim::HWY_NAMESPACE::loaded;
using sim::HWY_NAMESPACE::loaded3;
using sim::HWY_NAMESPACE::log2Of;
using sim::HWY_NAMESPACE::mixed;
using sim::HWY_NAMESPACE::most;
using sim::HWY_NAMESPACE::noLane;
using sim::HWY_NAMESPACE::powerOf;
using sim::HWY_NAMESPACE::powerOfTwo;
using sim::HWY_NAMESPACE::Quad;
using sim::HWY_NAMESPACE::quadOf;
#if HWY_TARGET != HWY_SCALAR
using sim::HWY_NAMESPACE::QuadTag;
#endif
using sim::HWY_NAMESPACE::root;
using sim::HWY_NAMESPACE::select;
using sim::HWY_NAMESPACE::sinOf;
using sim::HWY_NAMESPACE::smoothStep;
using sim::HWY_NAMESPACE::stored;
using sim::HWY_NAMESPACE::stored3;
using sim::HWY_NAMESPACE::Tag;
using sim::HWY_NAMESPACE::Triple;
using sim::HWY_NAMESPACE::tripleOf;
using sim::HWY_NAMESPACE::unit;
using sim::HWY_NAMESPACE::Yes;

inline constexpr std::size_t kMostLanes = sim::kLanes;

/// sRGB by a polynomial of the light's square root; within 1/1300 of the standard's curve. As in common.glsl.
template<class F>
HWY_INLINE F fastSrgb(F linear)
{
    const F c = clamped(linear, 0.0F, 1.0F);
    const F s = root(c);
    const F bent = (((F(-0.309565892F) * s + F(0.842780549F)) * s - F(0.944855478F)) * s + F(1.447898657F)) * s;
    return most(bent - F(0.037004691F), F(12.92F) * least(c, F(0.0031F)));
}
template<class F>
HWY_INLINE F linearFromSrgb(F c)
{
    return c * (c * (c * F(0.305306011F) + F(0.682171111F)) + F(0.012522878F));
}

} // namespace hairpaint::rendering::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
