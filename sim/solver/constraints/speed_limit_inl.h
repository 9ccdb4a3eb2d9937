// Bounds: no node is faster than kFastestM, and a strand that is not a number, or is nowhere near its root, starts
// again. So that a reset, a teleport or a dropped frame never explodes.
#if defined(HAIRPAINT_SIM_SPEED_LIMIT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_SIM_SPEED_LIMIT_INL_H_
#undef HAIRPAINT_SIM_SPEED_LIMIT_INL_H_
#else
#define HAIRPAINT_SIM_SPEED_LIMIT_INL_H_
#endif

#include "sim/base/lanes_inl.h"
#include "sim/solver/solver_layout.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

HWY_INLINE Lanes3 limited(const Lanes3& v)
{
    const Lanes square = dot(v, v);
    const Yes fast = !(square <= kFastestM * kFastestM);
    if (HWY_LIKELY(!any(fast)))
        return v;
    const Lanes factor = kFastestM / root(square);
    const Yes finite = square < 1e20F; // false for what is not a number
    return select(finite, v * select(fast, factor, 1.0F), Lanes3{0.0F, 0.0F, 0.0F});
}

/// What is not a number stays so down to the tip, and nothing else can be so far from its root.
HWY_INLINE Yes isLost(const Lanes3& rootHd, const Lanes3& tipHd)
{
    const Lanes3 reach = tipHd - rootHd;
    return !(dot(reach, reach) < 1e4F);
}

/// Strands with which something went wrong go back to where they were styled, without motion.
HWY_NOINLINE void restart(int nodes, Yes which, const float* HWY_RESTRICT rest, float* HWY_RESTRICT next,
                          float* HWY_RESTRICT previous)
{
    for (int i = 0; i < nodes; ++i) {
        const std::size_t offset = static_cast<std::size_t>(i) * StrandBlocks::kNodeStride;
        const Lanes3 styled = loaded3(rest + offset);
        stored3(select(which, styled, loaded3(next + offset)), next + offset);
        stored3(select(which, styled, loaded3(previous + offset)), previous + offset);
    }
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
