// Two rotations a hair, found hair by hair and applied to all nodes at once.
#include "sim/groom/turn_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/groom/turn_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include "sim/base/lanes_inl.h"
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

/// Rotations by Rodrigues' formula.
struct LaneTurn
{
    Lanes3 axis;
    Lanes sine, cosine;

    HWY_INLINE LaneTurn(const TurnTask::Turn& turn, std::size_t lane)
        : axis{loaded(turn.axis[0].data() + lane), loaded(turn.axis[1].data() + lane),
               loaded(turn.axis[2].data() + lane)},
          sine(loaded(turn.sine.data() + lane)), cosine(loaded(turn.cosine.data() + lane))
    {}
    [[nodiscard]] HWY_INLINE Lanes3 of(const Lanes3& v) const
    {
        return v * cosine + cross(axis, v) * sine + axis * (dot(axis, v) * (Lanes(1.0F) - cosine));
    }
};

void TurnLanesOf(const TurnTask& task)
{
    for (std::size_t lane = 0; lane < kLanes; lane += hn::Lanes(Tag())) {
        const Yes turns = loaded(task.turns.data() + lane) > 0.0F;
        if (!any(turns))
            continue;
        const LaneTurn lean(task.lean, lane);
        const LaneTurn across(task.across, lane);
        float* const nodes = task.nodesHd + lane;
        const Lanes3 rootHd = loaded3(nodes);
        for (std::size_t i = 1; i < static_cast<std::size_t>(task.nodes); ++i) {
            float* const at = nodes + i * StrandBlocks::kNodeStride;
            const Lanes3 own = loaded3(at);
            stored3(select(turns, rootHd + across.of(lean.of(own - rootHd)), own), at);
        }
    }
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include "sim/base/deterministic.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::sim {

namespace {

void setLane(TurnTask::Turn& turn, std::size_t lane, glm::vec3 axis, float rad)
{
    for (std::size_t i = 0; i < turn.axis.size(); ++i)
        turn.axis.at(i)[lane] = axis[static_cast<int>(i)];
    const SineCosine of = sinCosDet(rad);
    turn.sine[lane] = of.sine;
    turn.cosine[lane] = of.cosine;
}

} // namespace

void TurnTask::turnLane(std::size_t lane, const HairVariation& variation, float clump, const SkinFrame& frame,
                        float lengthM)
{
    constexpr float kMostAcrossM = 0.04F; ///< Greatest displacement of the tip across, m; kMostLiftM: off the skin.
    constexpr float kMostLiftM = 0.02F;
    const auto nodeAt = [this, lane](std::size_t node) {
        const float* at = nodesHd + node * StrandBlocks::kNodeStride + lane;
        return glm::vec3(at[0], at[kLanes], at[2 * kLanes]);
    };
    const auto within = [lengthM](float rad, float mostM) {
        return std::abs(rad) * lengthM > mostM ? std::copysign(mostM / lengthM, rad) : rad;
    };
    const float loose = 1.0F - clump;
    const glm::vec3 directionHd = nodeAt(1) - nodeAt(0);
    // Around an axis to the side of its first segment it goes towards the normal.
    const glm::vec3 sideHd = glm::cross(directionHd, frame.normal);
    const float sine = std::sqrt(glm::dot(sideHd, sideHd));
    const float standing = std::max(glm::dot(directionHd, frame.normal), 0.0F);
    const bool hasSide = sine > 1e-3F * standing && sine > 0.0F;
    const glm::vec3 axis = hasSide ? sideHd / sine : frame.x;
    const float upright = standing > 0.0F ? standing / std::sqrt(standing * standing + sine * sine) : 0.0F;
    setLane(across, lane, frame.normal, within(variation.acrossRad * loose, kMostAcrossM));
    setLane(lean, lane, axis,
            within(variation.leanRad * (upright * loose), kMostAcrossM) +
                (hasSide ? within(variation.liftRad, kMostLiftM) : 0.0F));
    turns[lane] = 1.0F;
}

HWY_EXPORT(TurnLanesOf);

void turnLanes(const TurnTask& task)
{
    HWY_DYNAMIC_DISPATCH(TurnLanesOf)(task);
}

} // namespace hairpaint::sim
#endif
