// Braid against braid: a node stays in the half spaces that BraidContact gave it (contacts known ahead, as Mirtich 2000
// and Catto 2005 treat them), and rubs on what is behind them.
#if defined(HAIRPAINT_SIM_BRAIDS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_SIM_BRAIDS_INL_H_
#undef HAIRPAINT_SIM_BRAIDS_INL_H_
#else
#define HAIRPAINT_SIM_BRAIDS_INL_H_
#endif

#include "sim/base/lanes_inl.h"
#include "sim/solver/solver_layout.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

/// The half spaces of a node of as many strands as there are lanes, and which of them it was kept in.
class BraidsBeside
{
public:
    /// `row`: at the node and the first lane, see BraidPlanes; `stepsOn`: since they were found, with this one.
    HWY_INLINE BraidsBeside(const float* HWY_RESTRICT row, int planes, int stepsOn)
        : m_row(row), m_planes(static_cast<std::size_t>(planes)), m_stepsOn(static_cast<float>(stepsOn)),
          m_velocity(planes > 0 ? loaded3(row) : Lanes3{0.0F, 0.0F, 0.0F}), m_touched(noLane())
    {}

    [[nodiscard]] HWY_INLINE Yes touched() const { return m_touched; }

    /// Moves p, of a node that was at `start`, into all of them. Returns whether any lane was out of one.
    HWY_INLINE bool keep(const GroupGains& gains, const Lanes3& start, Lanes3& p)
    {
        constexpr float kMostM = 0.01F; // A node is moved by at most this much for each.
        constexpr int kPasses = 2; // In a corner between two, one moves it out of the other; elsewhere one is enough.
        const Lanes3 headed = p;
        Yes corners = Lanes(0.0F) == Lanes(0.0F); // At first every lane.
        for (int pass = 0; pass < kPasses; ++pass) {
            Yes once = noLane();
            Yes twice = noLane();
            for (std::size_t i = 0; i < m_planes; ++i) {
                const Lanes3 normal = normalOf(i);
                const Lanes offset = loaded(m_row + (6 + 4 * i) * kLanes) + dot(normal, m_velocity) * m_stepsOn;
                const Lanes depth = offset - dot(normal, p);
                const Yes outside = (depth > 0.0F) & corners;
                if (!any(outside))
                    continue;
                p = select(outside, p + normal * least(depth, kMostM), p);
                m_touched = m_touched | outside;
                twice = twice | (once & outside);
                once = once | outside;
            }
            if (!any(twice))
                break;
            corners = twice;
        }
        if (!any(m_touched))
            return false;
        const Lanes3 push = p - headed;
        const Lanes push2 = dot(push, push);
        const Lanes3 against = p - start - m_velocity;
        const Lanes3 along = against - push * (dot(against, push) / most(push2, 1e-16F));
        // As heavy as a braid is; what undoes an overlap does not press.
        constexpr float kWeightM = kGravity * static_cast<float>(kStepSeconds * kStepSeconds);
        const Yes sticks = dot(along, along) <= least(push2, kWeightM * kWeightM) * gains.stickSlope2;
        const Lanes lost = select(sticks, 1.0F, 1.0F - gains.frictionKeep);
        p = select(m_touched, p - along * lost, p);
        return true;
    }

    /// `velocity` without what goes into or out of a braid that was touched, of `onHead`, the motion as the head sees
    /// it, of which `keep` is left.
    [[nodiscard]] HWY_INLINE Lanes3 leaving(const Lanes3& onHead, Lanes keep, Lanes3 velocity, const Lanes3& p) const
    {
        constexpr float kOnM = 1e-4F;
        Lanes3 against = onHead - m_velocity;
        for (std::size_t i = 0; i < m_planes; ++i) {
            const Lanes3 normal = normalOf(i);
            const Lanes offset = loaded(m_row + (6 + 4 * i) * kLanes) + dot(normal, m_velocity) * m_stepsOn;
            const Lanes across = dot(against, normal);
            const Yes on = m_touched & (dot(normal, p) - offset < kOnM);
            if (!any(on))
                continue;
            against = select(on, against - normal * across, against);
            velocity = select(on, velocity - normal * (across * keep), velocity);
        }
        return velocity;
    }

private:
    [[nodiscard]] HWY_INLINE Lanes3 normalOf(std::size_t plane) const
    {
        return loaded3(m_row + (3 + 4 * plane) * kLanes);
    }

    const float* HWY_RESTRICT m_row;
    std::size_t m_planes;
    float m_stepsOn;
    Lanes3 m_velocity; ///< That of the half spaces, m a step.
    Yes m_touched;
};

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
