// A coil is a spring: where its load differs from what it bore of late, it swings about another length. One damped
// oscillator a strand, so that it adds nothing to what the nodes' lengths cost.
#if defined(HAIRPAINT_SIM_COIL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_SIM_COIL_INL_H_
#undef HAIRPAINT_SIM_COIL_INL_H_
#else
#define HAIRPAINT_SIM_COIL_INL_H_
#endif

#include "sim/base/lanes_inl.h"
#include "sim/solver/solver_layout.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

/// A segment's length as the coil is stretched now.
HWY_INLINE Lanes coiledLength(const float* HWY_RESTRICT lanes)
{
    const Lanes own = loaded(lanes + kSegmentLength * kLanes);
    return own + own * loaded(lanes + kStretch * kLanes);
}

/// `pull`: the root's tension, by the length.
HWY_INLINE void swingCoil(int nodes, Yes which, Lanes pull, float* HWY_RESTRICT lanes)
{
    constexpr auto kStep = static_cast<float>(kStepSeconds);
    constexpr float kRate = 25.0F;         // rad/s: four times a second
    constexpr float kDamping = 0.12F;      // of the critical one
    constexpr float kOfLateS = 0.7F;       // over which a load becomes what it bore
    constexpr float kWeightsToGive = 0.5F; // more, or less, stretch or shorten it by kGive
    const Lanes give = loaded(lanes + kGive * kLanes);
    const Yes gives = which & (give > 0.0F);
    if (!any(gives))
        return;
    const float weight = (static_cast<float>(nodes) - 1.5F) * kGravity * kStep * kStep;
    const Lanes load = clamped(pull * (-1.0F / weight), -4.0F, 6.0F);
    const Lanes known = loaded(lanes + kLoad * kLanes);
    const Lanes late = select(known < kUnwanted, known, load);
    const Lanes more = load - late;
    const Lanes stretch = loaded(lanes + kStretch * kLanes);
    const Lanes speed = loaded(lanes + kStretchSpeed * kLanes);
    const Lanes target = give * (more * (1.0F / kWeightsToGive));
    Lanes faster = (target - stretch) * (kRate * kRate * kStep);
    faster = faster - speed * (2.0F * kDamping * kRate * kStep);
    const Lanes speedNow = speed + faster;
    const Lanes free = stretch + speedNow * kStep;
    const Lanes stretchNow = least(most(free, 0.0F - give), give);
    const Yes atEnd = free != stretchNow; // and where it is not a number
    stored(select(gives, stretchNow, stretch), lanes + kStretch * kLanes);
    stored(select(gives, select(atEnd, 0.0F, speedNow), speed), lanes + kStretchSpeed * kLanes);
    stored(select(gives, late + more * (kStep / kOfLateS), late), lanes + kLoad * kLanes);
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
