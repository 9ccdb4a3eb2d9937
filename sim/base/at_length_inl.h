// A node brought to its distance from the one before it.
#if defined(HAIRPAINT_SIM_AT_LENGTH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_SIM_AT_LENGTH_INL_H_
#undef HAIRPAINT_SIM_AT_LENGTH_INL_H_
#else
#define HAIRPAINT_SIM_AT_LENGTH_INL_H_
#endif

#include "sim/base/lanes_inl.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

/// The point at distance `length` from `parent` toward p. A point on its parent moves along `fallback` (unit).
HWY_INLINE Lanes3 atLength(const Lanes3& parent, const Lanes3& p, Lanes length, const Lanes3& fallback)
{
    Lanes3 edge = p - parent;
    Lanes square = dot(edge, edge);
    const Yes degenerate = !(square > 1e-16F); // also where p is not a number
    if (HWY_UNLIKELY(any(degenerate))) {
        edge = select(degenerate, fallback, edge);
        square = select(degenerate, dot(fallback, fallback), square);
    }
    return parent + edge * (length / root(square));
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
