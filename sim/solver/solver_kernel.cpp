// The solver's inner loop: prediction (strand_forces_inl.h), length constraint, contact, one exact pass from root to
// tip.
#include "sim/solver/solver_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/solver/solver_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include "sim/solver/strand_forces_inl.h"
#include "sim/solver/strand_kernel_inl.h"
#include <algorithm>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

/// A node leaves an ellipsoid or the skin by at most this much in a step, m.
constexpr float kFastestLeaveM = 0.02F;

constexpr int kRestorePasses = 4;
constexpr float kFirstOrder = 0.01F; ///< Fraction of a squared length up to which one pass restores it.

/// Equation 4 and algorithm 2 for all segments at once: nodes move along their segments by tensions that, to first
/// order, give every segment its length again. One row of three diagonals a segment, so that a pull at the tip is felt
/// at the root within the step and no momentum is made. Moves the strands of `which` alone unless `kAll`; returns those
/// of them that were further from their lengths than first order is good for. Adds the root's tension to `load`.
template<bool kAll, class D>
HWY_INLINE hn::Mask<D> restoreLengthsOnce(D d, int nodes, hn::Vec<D> length, hn::Mask<D> which, hn::Vec<D>& load,
                                          float* HWY_RESTRICT p)
{
    using V = hn::Vec<D>;
    const V zero = hn::Zero(d);
    const V one = hn::Set(d, 1.0F);
    const V half = hn::Set(d, 0.5F);
    const V tiny = hn::Set(d, 1e-16F);
    const V square = hn::Mul(length, length);
    const int last = nodes - 1;
    // Inverse masses: the root does not move, and the tip is half a node.
    const auto inverseMass = [last](int node) { return node == 0 ? 0.0F : node == last ? 2.0F : 1.0F; };
    HWY_ALIGN float rows[std::size_t{kMostNodes} * 2 * kLanes];
    Vec3<V> parent = load3(d, p);
    Vec3<V> edgeBefore{zero, zero, zero};
    V pivot = zero;
    V side = zero;
    V furthest = zero;
    for (int i = 1; i <= last; ++i) {
        const auto node = static_cast<std::size_t>(i);
        const Vec3<V> child = load3(d, p + node * StrandBlocks::kNodeStride);
        const Vec3<V> edge = sub(child, parent);
        const V edge2 = dot(edge, edge);
        const V beside = hn::Mul(hn::Set(d, -inverseMass(i - 1)), dot(edge, edgeBefore));
        const V first = hn::Mul(beside, pivot);
        const V whole =
            hn::Sub(hn::Mul(hn::Set(d, inverseMass(i) + inverseMass(i - 1)), edge2), hn::Mul(first, beside));
        pivot = hn::Div(one, hn::Max(whole, tiny));
        const V missing = hn::Sub(square, edge2);
        furthest = hn::Max(furthest, hn::Abs(missing));
        side = hn::Sub(hn::Mul(half, missing), hn::Mul(first, side));
        hn::StoreU(first, d, rows + (2 * node) * kLanes);
        hn::StoreU(hn::Mul(side, pivot), d, rows + (2 * node + 1) * kLanes);
        parent = child;
        edgeBefore = edge;
    }
    V first = zero;
    V tension = zero;
    Vec3<V> pullBelow{zero, zero, zero};
    Vec3<V> child = parent;
    for (int i = last; i >= 1; --i) {
        const auto node = static_cast<std::size_t>(i);
        float* const at = p + node * StrandBlocks::kNodeStride;
        parent = load3(d, at - StrandBlocks::kNodeStride);
        tension = hn::Sub(hn::LoadU(d, rows + (2 * node + 1) * kLanes), hn::Mul(first, tension));
        first = hn::LoadU(d, rows + (2 * node) * kLanes);
        const Vec3<V> pull = scale(sub(child, parent), tension);
        const Vec3<V> moved = addScaled(child, sub(pull, pullBelow), hn::Set(d, inverseMass(i)));
        store3(d, kAll ? moved : choose(which, moved, child), at);
        pullBelow = pull;
        child = parent;
    }
    load = hn::Add(load, hn::IfThenElseZero(which, tension));
    return hn::And(which, hn::Gt(furthest, hn::Mul(square, hn::Set(d, kFirstOrder))));
}

/// As often as it takes. Stiffness, which knows nothing of lengths, moves nodes far along a strand that is kept from a
/// sharply bent rest shape; what was not put right there went round as motion without end. Returns the root's tension.
template<class D>
HWY_INLINE hn::Vec<D> restoreLengths(D d, int nodes, hn::Vec<D> length, hn::Mask<D> which, float* HWY_RESTRICT p)
{
    hn::Vec<D> load = hn::Zero(d);
    which = restoreLengthsOnce<true>(d, nodes, length, which, load, p);
    for (int pass = 1; pass < kRestorePasses && HWY_UNLIKELY(!hn::AllFalse(d, which)); ++pass)
        which = restoreLengthsOnce<false>(d, nodes, length, which, load, p);
    return load;
}

/// A coil is a spring: where its load differs from what it bore of late, it swings about another length. One degree of
/// freedom a strand, so that it adds nothing to what the nodes' lengths cost. `pull`: the root's tension, by the
/// length.
template<class D>
HWY_INLINE void swing(D d, int nodes, hn::Mask<D> which, hn::Vec<D> pull, float* HWY_RESTRICT lanes)
{
    using V = hn::Vec<D>;
    constexpr auto kStep = static_cast<float>(kStepSeconds);
    constexpr float kRate = 25.0F;         // rad/s: four times a second
    constexpr float kDamping = 0.12F;      // of the critical one
    constexpr float kOfLateS = 0.7F;       // over which a load becomes what it bore
    constexpr float kWeightsToGive = 0.5F; // more, or less, stretch or shorten it by kGive
    const V give = hn::LoadU(d, lanes + kGive * kLanes);
    const hn::Mask<D> gives = hn::And(which, hn::Gt(give, hn::Zero(d)));
    if (hn::AllFalse(d, gives))
        return;
    const float weight = (static_cast<float>(nodes) - 1.5F) * 9.81F * kStep * kStep;
    const V load = hn::Min(hn::Max(hn::Mul(pull, hn::Set(d, -1.0F / weight)), hn::Set(d, -4.0F)), hn::Set(d, 6.0F));
    const V known = hn::LoadU(d, lanes + kLoad * kLanes);
    const V late = hn::IfThenElse(hn::Lt(known, hn::Set(d, kUnwanted)), known, load);
    const V more = hn::Sub(load, late);
    const V stretch = hn::LoadU(d, lanes + kStretch * kLanes);
    const V speed = hn::LoadU(d, lanes + kStretchSpeed * kLanes);
    const V target = hn::Mul(give, hn::Mul(more, hn::Set(d, 1.0F / kWeightsToGive)));
    V faster = hn::Mul(hn::Sub(target, stretch), hn::Set(d, kRate * kRate * kStep));
    faster = hn::Sub(faster, hn::Mul(speed, hn::Set(d, 2.0F * kDamping * kRate * kStep)));
    const V speedNow = hn::Add(speed, faster);
    const V free = hn::Add(stretch, hn::Mul(speedNow, hn::Set(d, kStep)));
    const V stretchNow = hn::Min(hn::Max(free, hn::Sub(hn::Zero(d), give)), give);
    const hn::Mask<D> atEnd = hn::Ne(free, stretchNow); // and where it is not a number
    hn::StoreU(hn::IfThenElse(gives, stretchNow, stretch), d, lanes + kStretch * kLanes);
    hn::StoreU(hn::IfThenElse(gives, hn::IfThenZeroElse(atEnd, speedNow), speed), d, lanes + kStretchSpeed * kLanes);
    hn::StoreU(hn::IfThenElse(gives, hn::Add(late, hn::Mul(more, hn::Set(d, kStep / kOfLateS))), late), d,
               lanes + kLoad * kLanes);
}

/// Keeps a node outside every ellipsoid, and it and its segment outside the skin; true where any lane was inside one.
/// `clearance`: from the skin, m; `ofSkin`: the lanes that were inside it.
template<class D>
HWY_INLINE bool collide(D d, const ColliderSet& colliders, const NeckTurn& neck, const float* HWY_RESTRICT lanes,
                        hn::Vec<D> clearance, bool first, const Vec3<hn::Vec<D>>& parent, Vec3<hn::Vec<D>>& p,
                        Contact<D>& contact, hn::Mask<D>& ofSkin)
{
    bool any = false;
    for (int c = 0; c < colliders.count; ++c)
        any |= pushOut(d, colliders.items[static_cast<std::size_t>(c)], neck,
                       hn::LoadU(d, lanes + (kScale + c) * kLanes), hn::Set(d, kFastestLeaveM), p, contact);
    if (colliders.skin.pairs != nullptr &&
        pushSegmentOutOfSkin(d, colliders.skin, neck, clearance, hn::Set(d, kFastestLeaveM), first, parent, p,
                             contact)) {
        ofSkin = contact.latest;
        any = true;
    }
    return any;
}

/// The same for a node that was pushed out and then brought to its length: out of the skin again where it was in it,
/// and of the ellipsoids where they are all there is.
template<class D>
HWY_INLINE bool collideAgain(D d, const ColliderSet& colliders, const NeckTurn& neck, const float* HWY_RESTRICT lanes,
                             hn::Vec<D> clearance, bool first, const Vec3<hn::Vec<D>>& parent, Vec3<hn::Vec<D>>& p,
                             Contact<D>& contact, hn::Mask<D> ofSkin)
{
    if (colliders.skin.pairs == nullptr)
        return collide(d, colliders, neck, lanes, clearance, first, parent, p, contact, ofSkin);
    if (hn::AllFalse(d, ofSkin))
        return false;
    const auto again = hn::IfThenElse(ofSkin, clearance, hn::Set(d, -kUnwanted));
    return pushSegmentOutOfSkin(d, colliders.skin, neck, again, hn::Set(d, kFastestLeaveM), first, parent, p, contact);
}

/// Friction: what a node moved along the surface since `start` is undone where it is little against how deep the node
/// was pressed in (it sticks), and shortened elsewhere.
template<class D>
HWY_INLINE Vec3<hn::Vec<D>> rubbed(D d, const GroupGains& gains, const Contact<D>& contact,
                                   const Vec3<hn::Vec<D>>& start, const Vec3<hn::Vec<D>>& p)
{
    const auto displacement = sub(p, start);
    const auto across = scale(contact.normal, hn::Mul(dot(displacement, contact.normal), contact.inverseNormal2));
    const auto along = sub(displacement, across);
    const auto sticks = hn::Le(dot(along, along), hn::Mul(contact.depth2, hn::Set(d, gains.stickSlope2)));
    const auto keep = hn::IfThenElse(sticks, hn::Zero(d), hn::Set(d, gains.frictionKeep));
    return choose(contact.touched, add(add(start, across), scale(along, keep)), p);
}

/// No node is faster than kFastestM.
template<class D>
HWY_INLINE Vec3<hn::Vec<D>> limited(D d, const Vec3<hn::Vec<D>>& v)
{
    const auto square = dot(v, v);
    const auto fast = hn::Not(hn::Le(square, hn::Set(d, kFastestM * kFastestM)));
    if (HWY_LIKELY(hn::AllFalse(d, fast)))
        return v;
    const auto factor = hn::Div(hn::Set(d, kFastestM), hn::Sqrt(square));
    const auto finite = hn::Lt(square, hn::Set(d, 1e20F)); // false for what is not a number
    const auto zero = hn::Zero(d);
    return choose(finite, scale(v, hn::IfThenElse(fast, factor, hn::Set(d, 1.0F))), Vec3<hn::Vec<D>>{zero, zero, zero});
}

/// Which lanes are further than kStillM from the place at `from`.
template<class D>
HWY_INLINE hn::Mask<D> departedFrom(D d, const float* HWY_RESTRICT from, const Vec3<hn::Vec<D>>& p)
{
    const auto displacement = sub(p, load3(d, from));
    return hn::Not(hn::Le(dot(displacement, displacement), hn::Set(d, kStillM * kStillM)));
}

template<class D>
HWY_INLINE void remember(D d, hn::Mask<D> which, const float* HWY_RESTRICT position, float* HWY_RESTRICT memory)
{
    store3(d, choose(which, load3(d, position), load3(d, memory)), memory);
}

/// Strands with which something went wrong go back to where they were styled, without motion.
template<class D>
HWY_NOINLINE void restart(D d, int nodes, hn::Mask<D> which, const float* HWY_RESTRICT rest, float* HWY_RESTRICT next,
                          float* HWY_RESTRICT previous)
{
    for (int i = 0; i < nodes; ++i) {
        const std::size_t offset = static_cast<std::size_t>(i) * StrandBlocks::kNodeStride;
        remember(d, which, rest + offset, next + offset);
        remember(d, which, rest + offset, previous + offset);
    }
}

/// What a step's strands read and write. Every pointer is already at their block and lane.
struct StrandRows
{
    const float* HWY_RESTRICT rest;
    const float* HWY_RESTRICT current;
    float* HWY_RESTRICT next;
    float* HWY_RESTRICT previous;
    float* HWY_RESTRICT lanes;
    float* HWY_RESTRICT p; ///< Scratch.
};

/// One step of as many strands as D has lanes, from their prediction on: restore(), place() of each node down to the
/// tip, finish().
template<class D>
class StrandStep
{
public:
    using V = hn::Vec<D>;

    HWY_INLINE StrandStep(D d, const GroupGains& gains, const StepForces& step, const StrandRows& rows) : m_rows(rows)
    {
        m_stillBefore = hn::LoadU(d, rows.lanes + kStill * kLanes);
        m_moving = hn::Lt(m_stillBefore, hn::Set(d, step.windy ? kUnwanted : kStillSteps));
        const V ownLength = hn::LoadU(d, rows.lanes + kSegmentLength * kLanes);
        m_length = hn::Add(ownLength, hn::Mul(ownLength, hn::LoadU(d, rows.lanes + kStretch * kLanes)));
        predict(d, gains, step, rows.rest, rows.current, rows.previous, rows.lanes, rows.p);
    }

    HWY_INLINE void restore(D d, const GroupGains& gains)
    {
        const V tension = restoreLengths(d, gains.nodes, m_length, m_moving, m_rows.p);
        swing(d, gains.nodes, m_moving, hn::Mul(tension, m_length), m_rows.lanes);
        m_parent = load3(d, m_rows.rest);
        store3(d, m_parent, m_rows.next);
        store3(d, m_parent, m_rows.previous);
        m_departed = hn::MaskFromVec(hn::Zero(d));
    }

    HWY_INLINE void place(D d, const GroupGains& gains, const ColliderSet& colliders, const StepForces& step, int i)
    {
        const std::size_t offset = static_cast<std::size_t>(i) * StrandBlocks::kNodeStride;
        const Vec3<V> start = load3(d, m_rows.current + offset);
        const Vec3<V> lie = load3(d, m_rows.lanes + kLieX * kLanes);
        const V eased = hn::Mul(m_length, hn::Set(d, kGirthSlope * static_cast<float>(i)));
        const V girth = hn::Min(hn::LoadU(d, m_rows.lanes + kGirth * kLanes), eased);
        const V clearance = hn::Add(girth, hn::Set(d, kSkinClearanceM));
        Vec3<V> placed = atLength(d, m_parent, load3(d, m_rows.p + offset), m_length, lie);
        Contact<D> contact = noContact(d);
        hn::Mask<D> ofSkin = contact.touched;
        if (collide(d, colliders, step.neck, m_rows.lanes, clearance, i == 1, m_parent, placed, contact, ofSkin)) {
            placed = rubbed(d, gains, contact, start, placed);
            placed = choose(contact.touched, atLength(d, m_parent, placed, m_length, lie), placed);
            Contact<D> second = noContact(d);
            if (collideAgain(d, colliders, step.neck, m_rows.lanes, clearance, i == 1, m_parent, placed, second,
                             ofSkin))
                placed = choose(second.touched, atLength(d, m_parent, placed, m_length, lie), placed);
        }

        const Vec3<V> onHead = sub(placed, start); // motion as the head sees it
        Vec3<V> velocity = step.toNewHead.identity ? onHead : sub(placed, moved(d, step.toNewHead, start));
        const V keep = hn::Mul(hn::LoadU(d, m_rows.lanes + kHoldKeep * kLanes),
                               hn::Set(d, gains.rootKeep[static_cast<std::size_t>(i)]));
        velocity = sub(velocity, scale(onHead, hn::Sub(hn::Set(d, 1.0F), keep)));
        // In contact nothing moves into the surface or springs off it.
        if (!hn::AllFalse(d, contact.touched)) {
            const V across = hn::Mul(dot(onHead, contact.normal), contact.inverseNormal2);
            const Vec3<V> sliding = sub(velocity, scale(contact.normal, hn::Mul(across, keep)));
            velocity = choose(contact.touched, sliding, velocity);
        }
        velocity = limited(d, velocity);
        placed = choose(m_moving, placed, start);
        store3(d, placed, m_rows.next + offset);
        store3(d, choose(m_moving, sub(placed, velocity), placed), m_rows.previous + offset);
        // Watching two places instead of speeds: a node that trembles where the hair leaves the head does not move.
        if (i == gains.nodes / 2)
            m_departed = hn::Or(m_departed, departedFrom(d, m_rows.lanes + kMiddleX * kLanes, placed));
        if (i + 1 == gains.nodes)
            m_departed = hn::Or(m_departed, departedFrom(d, m_rows.lanes + kTipX * kLanes, placed));
        m_parent = placed;
    }

    HWY_INLINE void finish(D d, const GroupGains& gains, const StepForces& step)
    {
        // What is not a number stays so down to the tip, and nothing else can be so far from its root.
        const Vec3<V> reach = sub(m_parent, load3(d, m_rows.rest));
        const hn::Mask<D> lost = hn::Not(hn::Lt(dot(reach, reach), hn::Set(d, 1e4F)));
        if (HWY_UNLIKELY(!hn::AllFalse(d, lost)))
            restart(d, gains.nodes, lost, m_rows.rest, m_rows.next, m_rows.previous);
        if (!hn::AllFalse(d, m_departed)) {
            const auto nodes = static_cast<std::size_t>(gains.nodes);
            remember(d, m_departed, m_rows.next + nodes / 2 * StrandBlocks::kNodeStride,
                     m_rows.lanes + kMiddleX * kLanes);
            remember(d, m_departed, m_rows.next + (nodes - 1) * StrandBlocks::kNodeStride,
                     m_rows.lanes + kTipX * kLanes);
        }
        const V counted = hn::Add(m_stillBefore, hn::Set(d, 1.0F));
        const V still = step.windy ? hn::Zero(d) : hn::IfThenZeroElse(m_departed, counted);
        hn::StoreU(hn::IfThenElse(m_moving, still, counted), d, m_rows.lanes + kStill * kLanes);
    }

private:
    StrandRows m_rows;
    V m_stillBefore, m_length;
    hn::Mask<D> m_moving, m_departed;
    Vec3<V> m_parent;
};

template<class D>
HWY_INLINE bool asleep(D d, const float* HWY_RESTRICT lanes, float steps)
{
    return hn::AllTrue(d, hn::Ge(hn::LoadU(d, lanes + kStill * kLanes), hn::Set(d, steps)));
}

void StepBlocks(const SolverBlocks& blocks, const GroupGains& gains, const ColliderSet& colliders,
                std::span<const StepForces> steps, int from, std::size_t begin, std::size_t end)
{
    using D = hn::CappedTag<float, kLanes>;
    const D d;
    const std::size_t width = hn::Lanes(d);
    const std::size_t blockFloats = static_cast<std::size_t>(gains.nodes) * StrandBlocks::kNodeStride;
    HWY_ALIGN float scratch[std::size_t{kMostNodes} * StrandBlocks::kNodeStride];
    std::fill(blocks.awake + begin, blocks.awake + end, std::uint8_t{0});
    for (std::size_t block = begin; block < end; ++block) {
        for (std::size_t lane = 0; lane < kLanes; lane += width) {
            const std::size_t at = block * blockFloats + lane;
            float* const lanes = blocks.lanes + block * blocks.laneRows * kLanes + lane;
            // All steps while the strands are in the cache.
            auto read = static_cast<std::size_t>(from);
            for (const StepForces& step : steps) {
                // Asleep for two steps: both positions are the same, and nothing needs to be written.
                if (!asleep(d, lanes, step.windy ? kUnwanted : kStillSteps + 2.0F)) {
                    StrandStep<D> strands(d, gains, step,
                                          {blocks.rest + at, blocks.positions[read] + at,
                                           blocks.positions[1 - read] + at, blocks.previous + at, lanes, scratch});
                    strands.restore(d, gains);
                    for (int node = 1; node < gains.nodes; ++node)
                        strands.place(d, gains, colliders, step, node);
                    strands.finish(d, gains, step);
                }
                read = 1 - read;
            }
            if (!asleep(d, lanes, kStillSteps + 2.0F))
                blocks.awake[block] = 1;
        }
    }
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hairpaint::sim {

HWY_EXPORT(StepBlocks);

void stepBlocks(const SolverBlocks& blocks, const GroupGains& gains, const ColliderSet& colliders,
                std::span<const StepForces> steps, int from, std::size_t begin, std::size_t end)
{
    HWY_DYNAMIC_DISPATCH(StepBlocks)(blocks, gains, colliders, steps, from, begin, end);
}

} // namespace hairpaint::sim
#endif
