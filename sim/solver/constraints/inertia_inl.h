// Inertia and drag: what a node does that nothing acts on.
// Equation 5 (Verlet's integration): x' = x + (x - x*) + a dt^2, the second term shortened by drag.
#if defined(HAIRPAINT_SIM_INERTIA_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_SIM_INERTIA_INL_H_
#undef HAIRPAINT_SIM_INERTIA_INL_H_
#else
#define HAIRPAINT_SIM_INERTIA_INL_H_
#endif

#include "sim/solver/rigid_motion_inl.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

/// Where a node is, and its displacement of the last step less what drag took. In the head's present frame.
struct NodeMotion
{
    Lanes3 position, velocity;
};

/// `current`, `previous`: at the strands' root.
HWY_INLINE NodeMotion motionOf(const StepForces& step, float drag, const float* HWY_RESTRICT current,
                               const float* HWY_RESTRICT previous, int node)
{
    const std::size_t offset = static_cast<std::size_t>(node) * StrandBlocks::kNodeStride;
    Lanes3 x = loaded3(current + offset);
    Lanes3 earlier = loaded3(previous + offset);
    if (!step.toNewHead.identity) {
        x = moved(step.toNewHead, x);
        earlier = moved(step.toNewHead, earlier);
    }
    return {x, (x - earlier) * drag};
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
