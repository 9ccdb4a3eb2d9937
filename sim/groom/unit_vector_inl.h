// Lengths and directions of vectors that may have none, a lane each.
#if defined(HAIRPAINT_SIM_UNIT_VECTOR_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_SIM_UNIT_VECTOR_INL_H_
#undef HAIRPAINT_SIM_UNIT_VECTOR_INL_H_
#else
#define HAIRPAINT_SIM_UNIT_VECTOR_INL_H_
#endif

#include "sim/base/lanes_inl.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

HWY_INLINE Lanes lengthOf(const Lanes3& v)
{
    return root(dot(v, v));
}

HWY_INLINE Lanes3 quotient(const Lanes3& v, Lanes by)
{
    return {v.x / by, v.y / by, v.z / by};
}

/// As unitVectorOr() of unit_vector.h.
HWY_INLINE Lanes3 unitOr(const Lanes3& v, const Lanes3& fallback)
{
    const Lanes length = lengthOf(v);
    return select(length > 1e-9F, quotient(v, length), fallback);
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
