// Length: no segment stretches. Equation 4 and algorithm 2 for all segments at once: nodes move along their segments by
// tensions that, to first order, give every segment its length again. One row of three diagonals a segment (as Han and
// Harada 2013), so that a pull at the tip is felt at the root within the step and no momentum is made.
#if defined(HAIRPAINT_SIM_LENGTH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_SIM_LENGTH_INL_H_
#undef HAIRPAINT_SIM_LENGTH_INL_H_
#else
#define HAIRPAINT_SIM_LENGTH_INL_H_
#endif

#include "sim/base/lanes_inl.h"
#include "sim/solver/solver_layout.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

constexpr int kRestorePasses = 4;
constexpr float kFirstOrder = 0.01F; ///< Fraction of a squared length up to which one pass restores it.

/// Moves the strands of `which` alone unless `kAll`; returns those of them that were further from their lengths than
/// first order is good for. Adds the root's tension to `load`.
template<bool kAll>
HWY_INLINE Yes restoreLengthsOnce(int nodes, Lanes length, Yes which, Lanes& load, float* HWY_RESTRICT p)
{
    const Lanes square = length * length;
    const int last = nodes - 1;
    // Inverse masses: the root does not move, and the tip is half a node.
    const auto inverseMass = [last](int node) { return node == 0 ? 0.0F : node == last ? 2.0F : 1.0F; };
    HWY_ALIGN float rows[std::size_t{kMostNodes} * 2 * kLanes];
    Lanes3 parent = loaded3(p);
    Lanes3 edgeBefore{0.0F, 0.0F, 0.0F};
    Lanes pivot(0.0F);
    Lanes side(0.0F);
    Lanes furthest(0.0F);
    for (int i = 1; i <= last; ++i) {
        const auto node = static_cast<std::size_t>(i);
        const Lanes3 child = loaded3(p + node * StrandBlocks::kNodeStride);
        const Lanes3 edge = child - parent;
        const Lanes edge2 = dot(edge, edge);
        const Lanes beside = -inverseMass(i - 1) * dot(edge, edgeBefore);
        const Lanes first = beside * pivot;
        const Lanes whole = (inverseMass(i) + inverseMass(i - 1)) * edge2 - first * beside;
        pivot = Lanes(1.0F) / most(whole, 1e-16F);
        const Lanes missing = square - edge2;
        furthest = most(furthest, magnitude(missing));
        side = 0.5F * missing - first * side;
        stored(first, rows + (2 * node) * kLanes);
        stored(side * pivot, rows + (2 * node + 1) * kLanes);
        parent = child;
        edgeBefore = edge;
    }
    Lanes first(0.0F);
    Lanes tension(0.0F);
    Lanes3 pullBelow{0.0F, 0.0F, 0.0F};
    Lanes3 child = parent;
    for (int i = last; i >= 1; --i) {
        const auto node = static_cast<std::size_t>(i);
        float* const at = p + node * StrandBlocks::kNodeStride;
        parent = loaded3(at - StrandBlocks::kNodeStride);
        tension = loaded(rows + (2 * node + 1) * kLanes) - first * tension;
        first = loaded(rows + (2 * node) * kLanes);
        const Lanes3 pull = (child - parent) * tension;
        const Lanes3 restored = child + (pull - pullBelow) * inverseMass(i);
        stored3(kAll ? restored : select(which, restored, child), at);
        pullBelow = pull;
        child = parent;
    }
    load = load + onlyWhere(which, tension);
    return which & (furthest > square * kFirstOrder);
}

/// As often as it takes. Stiffness, which knows nothing of lengths, moves nodes far along a strand that is kept from a
/// sharply bent rest shape; what was not put right there went round as motion without end. Returns the root's tension.
HWY_INLINE Lanes restoreLengths(int nodes, Lanes length, Yes which, float* HWY_RESTRICT p)
{
    Lanes load(0.0F);
    which = restoreLengthsOnce<true>(nodes, length, which, load, p);
    for (int pass = 1; pass < kRestorePasses && HWY_UNLIKELY(any(which)); ++pass)
        which = restoreLengthsOnce<false>(nodes, length, which, load, p);
    return load;
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
