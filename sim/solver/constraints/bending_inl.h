// Stiffness and gel: a strand resists bending away from its rest shape, and gel holds every node at it.
//
// Displacements u from the rest shape after the step, from those u* that free nodes would have, solve
// M ((1 + hold + loft) u - u*) + bend K u = 0: K is the matrix of squared second differences of a beam clamped at its
// root and free at its tip, M the nodes' masses, the tip half of the others. Implicit, so that a stiff hair takes no
// smaller step; exact for any deflection of a strand that does not stretch, since its curvature is then its second
// derivative (Bergou et al. 2006, quadratic bending). Five diagonals: rows are eliminated while nodes are predicted.
#if defined(HAIRPAINT_SIM_BENDING_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_SIM_BENDING_INL_H_
#undef HAIRPAINT_SIM_BENDING_INL_H_
#else
#define HAIRPAINT_SIM_BENDING_INL_H_
#endif

#include "sim/base/lanes_inl.h"
#include "sim/solver/solver_layout.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

class BendingSolve
{
public:
    /// `rows`: scratch, [nodes][2][kLanes].
    HWY_INLINE BendingSolve(int nodes, const float* HWY_RESTRICT lanes, float* HWY_RESTRICT rows)
        : m_rows(rows), m_last(nodes - 1), m_bend(loaded(lanes + kBend * kLanes)),
          m_held(1.0F + loaded(lanes + kHold * kLanes)), m_loft(loaded(lanes + kLoft * kLanes)),
          m_hasLoft(any(m_loft > 0.0F)), m_perLoft(loaded(lanes + kSegmentLength * kLanes) * (1.0F / kLoftM)),
          m_pivot(0.0F), m_secondPivot(0.0F), m_beside(0.0F), m_above{0.0F, 0.0F, 0.0F}, m_secondAbove(m_above)
    {}

    /// The next node from the root on; `free`: its u*. Writes its eliminated right-hand side into p.
    HWY_INLINE void eliminate(int i, const Lanes3& free, float* HWY_RESTRICT p)
    {
        const auto node = static_cast<std::size_t>(i);
        const Lanes mass(i == m_last ? 0.5F : 1.0F);
        const Lanes diagonal(i == 1 ? 7.0F : i == m_last ? 1.0F : i == m_last - 1 ? 5.0F : 6.0F);
        const Lanes second = m_bend * m_secondPivot;
        m_beside = m_bend * (i == 1 ? 0.0F : i == m_last ? -2.0F : -4.0F) - second * m_beside;
        const Lanes first = m_beside * m_pivot;
        const Lanes held = m_hasLoft ? m_held + loftAt(i, free) : m_held;
        const Lanes whole = mass * held + m_bend * diagonal - first * m_beside - second * m_bend;
        m_secondPivot = m_pivot;
        m_pivot = Lanes(1.0F) / select(whole > 0.0F, whole, 1.0F);
        const Lanes3 side = free * mass - m_above * first - m_secondAbove * second;
        m_secondAbove = m_above;
        m_above = side;
        stored3(side * m_pivot, p + node * StrandBlocks::kNodeStride);
        stored(first, m_rows + (2 * node) * kLanes);
        stored(second, m_rows + (2 * node + 1) * kLanes);
    }

    /// From what eliminate() left in p to positions.
    HWY_INLINE void substitute(const float* HWY_RESTRICT rest, float* HWY_RESTRICT p) const
    {
        Lanes3 below{0.0F, 0.0F, 0.0F};
        Lanes3 secondBelow = below;
        Lanes first(0.0F);
        Lanes second(0.0F);
        Lanes secondOfBelow(0.0F);
        for (int i = m_last; i >= 1; --i) {
            const auto node = static_cast<std::size_t>(i);
            float* const at = p + node * StrandBlocks::kNodeStride;
            const Lanes3 u = loaded3(at) - below * first - secondBelow * second;
            stored3(loaded3(rest + node * StrandBlocks::kNodeStride) + u, at);
            secondBelow = below;
            below = u;
            second = secondOfBelow;
            first = loaded(m_rows + (2 * node) * kLanes);
            secondOfBelow = loaded(m_rows + (2 * node + 1) * kLanes);
        }
    }

private:
    /// Strength at node i of the spring that carries the coat. It yields where a step would move the node by more than
    /// kLoftYieldM, so that wind bends hair at its roots.
    [[nodiscard]] HWY_INLINE Lanes loftAt(int i, const Lanes3& free) const
    {
        const Lanes near = most(1.0F - m_perLoft * static_cast<float>(i), 0.0F);
        const Lanes beyond = most(root(dot(free, free)) - kLoftYieldM, 1e-9F);
        return least(m_loft * near * near, Lanes(kLoftYieldM) / beyond);
    }

    float* HWY_RESTRICT m_rows;
    int m_last;
    Lanes m_bend, m_held;
    Lanes m_loft;
    bool m_hasLoft; ///< Whether any strand's loft is above 0.
    Lanes m_perLoft;
    Lanes m_pivot, m_secondPivot;  ///< Inverses of the last two pivots.
    Lanes m_beside;                ///< The last row's own term beside the diagonal.
    Lanes3 m_above, m_secondAbove; ///< Eliminated right-hand sides.
};

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
