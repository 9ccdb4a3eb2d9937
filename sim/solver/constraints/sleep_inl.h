// Sleep: a strand of which nothing moved for kStillSteps costs nothing until something does. Two points are watched
// instead of speeds: a node that trembles where the hair leaves the head does not move.
#if defined(HAIRPAINT_SIM_SLEEP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_SIM_SLEEP_INL_H_
#undef HAIRPAINT_SIM_SLEEP_INL_H_
#else
#define HAIRPAINT_SIM_SLEEP_INL_H_
#endif

#include "sim/base/lanes_inl.h"
#include "sim/solver/solver_layout.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

HWY_INLINE Yes departedFrom(const float* HWY_RESTRICT memory, const Lanes3& p, float stillM)
{
    const Lanes3 displacement = p - loaded3(memory);
    return !(dot(displacement, displacement) <= stillM * stillM);
}

class StillWatch
{
public:
    HWY_INLINE StillWatch(bool windy, float stillM, const float* HWY_RESTRICT lanes)
        : m_stillM(stillM), m_before(loaded(lanes + kStill * kLanes)),
          m_moving(m_before < (windy ? kUnwanted : kStillSteps)), m_departed(noLane())
    {}

    /// The strands that this step moves.
    [[nodiscard]] HWY_INLINE Yes moving() const { return m_moving; }

    HWY_INLINE void see(int node, int nodes, const Lanes3& p, const float* HWY_RESTRICT lanes)
    {
        if (node == nodes / 2)
            m_departed = m_departed | departedFrom(lanes + kMiddleX * kLanes, p, m_stillM);
        if (node + 1 == nodes)
            m_departed = m_departed | departedFrom(lanes + kTipX * kLanes, p, m_stillM);
    }

    HWY_INLINE void finish(bool windy, int nodes, const float* HWY_RESTRICT next, float* HWY_RESTRICT lanes) const
    {
        if (any(m_departed)) {
            const auto count = static_cast<std::size_t>(nodes);
            remember(next + count / 2 * StrandBlocks::kNodeStride, lanes + kMiddleX * kLanes);
            remember(next + (count - 1) * StrandBlocks::kNodeStride, lanes + kTipX * kLanes);
        }
        const Lanes counted = m_before + 1.0F;
        const Lanes still = windy ? Lanes(0.0F) : select(m_departed, 0.0F, counted);
        stored(select(m_moving, still, counted), lanes + kStill * kLanes);
    }

private:
    HWY_INLINE void remember(const float* HWY_RESTRICT position, float* HWY_RESTRICT memory) const
    {
        stored3(select(m_departed, loaded3(position), loaded3(memory)), memory);
    }

    float m_stillM;
    Lanes m_before;
    Yes m_moving, m_departed;
};

/// Whether every strand has slept for so many steps.
HWY_INLINE bool asleep(const float* HWY_RESTRICT lanes, float steps)
{
    return all(loaded(lanes + kStill * kLanes) >= steps);
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
