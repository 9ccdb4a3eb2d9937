// The solver's inner loop: prediction, length constraint, contact, one exact pass from root to tip.
#include "sim/solver/solver_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/solver/solver_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include "sim/solver/strand_kernel_inl.h"
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

/// A node leaves an ellipsoid or the skin by at most this much in a step, m.
constexpr float kFastestLeaveM = 0.02F;

/// sin(x) for |x| < 4 pi, within 0.002: two parabolas.
template<class D>
HWY_INLINE hn::Vec<D> waveSin(D d, hn::Vec<D> x)
{
    const auto turns = hn::Round(hn::Mul(x, hn::Set(d, 0.15915494F)));
    const auto y = hn::Sub(x, hn::Mul(turns, hn::Set(d, 6.2831853F)));
    const auto a =
        hn::Sub(hn::Mul(y, hn::Set(d, 1.2732395F)), hn::Mul(hn::Mul(y, hn::Abs(y)), hn::Set(d, 0.40528473F)));
    return hn::Add(hn::Mul(hn::Sub(hn::Mul(a, hn::Abs(a)), a), hn::Set(d, 0.225F)), a);
}

/// The air around one strand: the wind there, and its two waves of turbulence.
template<class D>
struct StrandAir
{
    Vec3<hn::Vec<D>> wind;
    hn::Vec<D> sinA, cosA, sinB, cosB;
};

template<class D>
HWY_INLINE StrandAir<D> airAround(D d, const StepForces& step, const float* HWY_RESTRICT lanes)
{
    const auto quarter = hn::Set(d, 1.5707963F);
    const auto gustWave = waveSin(d, hn::Sub(hn::LoadU(d, lanes + kPhaseGust * kLanes), hn::Set(d, step.phaseGust)));
    const auto half = hn::Set(d, 0.5F);
    const auto lull = hn::Mul(hn::Set(d, step.gust), hn::Sub(half, hn::Mul(half, gustWave)));
    const auto exposure = hn::LoadU(d, lanes + kExposure * kLanes);
    const auto strength = hn::Mul(exposure, hn::Sub(hn::Set(d, 1.0F), lull));
    const auto a = hn::Sub(hn::LoadU(d, lanes + kPhaseA * kLanes), hn::Set(d, step.phaseA));
    const auto b = hn::Sub(hn::LoadU(d, lanes + kPhaseB * kLanes), hn::Set(d, step.phaseB));
    const auto wave = [&](hn::Vec<D> phase) { return hn::Mul(waveSin(d, phase), exposure); };
    return {scale(set3(d, step.wind), strength), wave(a), wave(hn::Add(a, quarter)), wave(b),
            wave(hn::Add(b, quarter))};
}

/// Velocity of the air at one node, m a step.
template<class D>
HWY_INLINE Vec3<hn::Vec<D>> airAt(D d, const StrandAir<D>& air, const GroupGains& gains, const StepForces& step,
                                  std::size_t node, const Vec3<hn::Vec<D>>& p)
{
    const auto waveA = hn::Add(hn::Mul(air.sinA, hn::Set(d, gains.waveACos[node])),
                               hn::Mul(air.cosA, hn::Set(d, gains.waveASin[node])));
    const auto waveB = hn::Add(hn::Mul(air.sinB, hn::Set(d, gains.waveBCos[node])),
                               hn::Mul(air.cosB, hn::Set(d, gains.waveBSin[node])));
    auto wind = addScaled(air.wind, set3(d, step.swirlA), waveA);
    wind = addScaled(wind, set3(d, step.swirlB), waveB);
    for (int i = 0; i < step.puffCount; ++i) {
        const PuffForces& puff = step.puffs[static_cast<std::size_t>(i)];
        const auto away = sub(p, set3(d, puff.centre));
        const auto left =
            hn::Max(hn::Zero(d), hn::Sub(hn::Set(d, 1.0F), hn::Mul(dot(away, away), hn::Set(d, puff.inverseRadius2))));
        wind = addScaled(wind, set3(d, puff.velocity), hn::Mul(left, left));
    }
    return wind;
}

constexpr float kBendingDamping = 0.2F; ///< Fraction of the motion against the mean of both neighbours lost in a step.

/// Where a node is, and its displacement of the last step less what drag took.
template<class D>
struct NodeMotion
{
    Vec3<hn::Vec<D>> position, velocity;
};

template<class D>
HWY_INLINE NodeMotion<D> motionOf(D d, const StepForces& step, hn::Vec<D> drag, const float* HWY_RESTRICT current,
                                  const float* HWY_RESTRICT previous, int node)
{
    const std::size_t offset = static_cast<std::size_t>(node) * StrandBlocks::kNodeStride;
    Vec3<hn::Vec<D>> x = load3(d, current + offset);
    Vec3<hn::Vec<D>> earlier = load3(d, previous + offset);
    if (!step.toNewHead.identity) {
        x = moved(d, step.toNewHead, x);
        earlier = moved(d, step.toNewHead, earlier);
    }
    return {x, scale(sub(x, earlier), drag)};
}

/// Equation 5 with drag, gravity and wind, then the strand's own stiffness, into p: [nodes][3][kLanes].
///
/// Displacements u from the rest shape after the step, from those u* that free nodes would have, solve
/// M ((1 + hold) u - u*) + bend K u = 0: K is the matrix of squared second differences of a beam clamped at its root
/// and free at its tip, M the nodes' masses, the tip half of the others. Implicit, so that a stiff hair takes no
/// smaller step; exact for any deflection of a strand that does not stretch, since its curvature is then its second
/// derivative (Bergou et al. 2006). Five diagonals: rows are eliminated while the nodes are predicted.
template<class D>
HWY_INLINE void predict(D d, const GroupGains& gains, const StepForces& step, const float* HWY_RESTRICT rest,
                        const float* HWY_RESTRICT current, const float* HWY_RESTRICT previous,
                        const float* HWY_RESTRICT lanes, float* HWY_RESTRICT p)
{
    using V = hn::Vec<D>;
    const V drag = hn::Set(d, gains.drag);
    const V inverseSquare = hn::LoadU(d, lanes + kInverseSquare * kLanes);
    const Vec3<V> gravity = scale(set3(d, step.gravity), hn::Set(d, gains.gravityScale));
    StrandAir<D> air{};
    if (step.windy)
        air = airAround(d, step, lanes);

    const V zero = hn::Zero(d);
    const V one = hn::Set(d, 1.0F);
    const V bend = hn::LoadU(d, lanes + kBend * kLanes);
    const V held = hn::Add(one, hn::LoadU(d, lanes + kHold * kLanes));
    HWY_ALIGN float rows[std::size_t{kMostNodes} * 2 * kLanes];
    V pivot = zero; // Inverses of the last two, and the last row's own term beside the diagonal.
    V secondPivot = zero;
    V beside = zero;
    Vec3<V> above{zero, zero, zero}; // Eliminated right-hand sides.
    Vec3<V> secondAbove = above;

    Vec3<V> before = load3(d, current);
    if (!step.toNewHead.identity)
        before = moved(d, step.toNewHead, before);
    store3(d, load3(d, rest), p);
    const int last = gains.nodes - 1;
    NodeMotion<D> upcoming = motionOf(d, step, drag, current, previous, 1);
    Vec3<V> velocityBefore{zero, zero, zero};
    for (int i = 1; i <= last; ++i) {
        const auto node = static_cast<std::size_t>(i);
        const std::size_t offset = node * StrandBlocks::kNodeStride;
        const Vec3<V> x = upcoming.position;
        Vec3<V> v = upcoming.velocity;
        // Bending dies away within the fibre; a strand that turns as a whole does not notice.
        if (i < last) {
            upcoming = motionOf(d, step, drag, current, previous, i + 1);
            const Vec3<V> unbent = scale(add(velocityBefore, upcoming.velocity), hn::Set(d, 0.5F));
            velocityBefore = v;
            v = addScaled(v, sub(unbent, v), hn::Set(d, kBendingDamping));
        }
        if (step.windy) {
            // -((t x r) x t) for the relative velocity r: only its part across the segment drags.
            const Vec3<V> edge = sub(x, before);
            const Vec3<V> relative = sub(airAt(d, air, gains, step, node, x), v);
            const V along = hn::Mul(dot(edge, relative), inverseSquare);
            const Vec3<V> across = sub(relative, scale(edge, along));
            v = addScaled(v, across, hn::Set(d, gains.windGain));
        }
        const Vec3<V> free = sub(add(add(x, v), gravity), load3(d, rest + offset));
        before = x;

        const V mass = hn::Set(d, i == last ? 0.5F : 1.0F);
        const V diagonal = hn::Set(d, i == 1 ? 7.0F : i == last ? 1.0F : i == last - 1 ? 5.0F : 6.0F);
        const V second = hn::Mul(bend, secondPivot);
        beside = hn::Sub(hn::Mul(bend, hn::Set(d, i == 1 ? 0.0F : i == last ? -2.0F : -4.0F)), hn::Mul(second, beside));
        const V first = hn::Mul(beside, pivot);
        const V whole = hn::Sub(hn::Sub(hn::Add(hn::Mul(mass, held), hn::Mul(bend, diagonal)), hn::Mul(first, beside)),
                                hn::Mul(second, bend));
        secondPivot = pivot;
        pivot = hn::Div(one, hn::IfThenElse(hn::Gt(whole, zero), whole, one));
        const Vec3<V> side = sub(sub(scale(free, mass), scale(above, first)), scale(secondAbove, second));
        secondAbove = above;
        above = side;
        store3(d, scale(side, pivot), p + offset);
        hn::StoreU(first, d, rows + (2 * node) * kLanes);
        hn::StoreU(second, d, rows + (2 * node + 1) * kLanes);
    }
    Vec3<V> below{zero, zero, zero};
    Vec3<V> secondBelow = below;
    V first = zero;
    V second = zero;
    V secondOfBelow = zero;
    for (int i = last; i >= 1; --i) {
        const auto node = static_cast<std::size_t>(i);
        float* const at = p + node * StrandBlocks::kNodeStride;
        const Vec3<V> u = sub(sub(load3(d, at), scale(below, first)), scale(secondBelow, second));
        store3(d, add(load3(d, rest + node * StrandBlocks::kNodeStride), u), at);
        secondBelow = below;
        below = u;
        second = secondOfBelow;
        first = hn::LoadU(d, rows + (2 * node) * kLanes);
        secondOfBelow = hn::LoadU(d, rows + (2 * node + 1) * kLanes);
    }
}

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
template<class D>
HWY_INLINE bool collide(D d, const ColliderSet& colliders, const NeckTurn& neck, const float* HWY_RESTRICT lanes,
                        bool first, const Vec3<hn::Vec<D>>& parent, Vec3<hn::Vec<D>>& p, Contact<D>& contact)
{
    bool any = false;
    for (int c = 0; c < colliders.count; ++c)
        any |= pushOut(d, colliders.items[static_cast<std::size_t>(c)], neck,
                       hn::LoadU(d, lanes + (kScale + c) * kLanes), hn::Set(d, kFastestLeaveM), p, contact);
    if (colliders.skin.values != nullptr)
        any |= pushSegmentOutOfSkin(d, colliders.skin, neck, hn::Set(d, kSkinClearanceM), hn::Set(d, kFastestLeaveM),
                                    first, parent, p, contact);
    return any;
}

/// Friction: what a node moved along the surface since `start` is undone where it is little against how deep the node
/// was pressed in (it sticks), and shortened elsewhere.
template<class D>
HWY_INLINE Vec3<hn::Vec<D>> rubbed(D d, const GroupGains& gains, const Contact<D>& contact,
                                   const Vec3<hn::Vec<D>>& start, const Vec3<hn::Vec<D>>& p)
{
    const auto displacement = sub(p, start);
    const auto across = scale(contact.normal, hn::Div(dot(displacement, contact.normal), contact.normal2));
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

/// One step of the strands in lanes lane..lane + Lanes(d). Every pointer is already at this block and lane.
template<class D>
HWY_INLINE void stepStrands(D d, const GroupGains& gains, const ColliderSet& colliders, const StepForces& step,
                            const float* HWY_RESTRICT rest, const float* HWY_RESTRICT current, float* HWY_RESTRICT next,
                            float* HWY_RESTRICT previous, float* HWY_RESTRICT lanes, float* HWY_RESTRICT p)
{
    using V = hn::Vec<D>;
    const V stillBefore = hn::LoadU(d, lanes + kStill * kLanes);
    const V asleepFrom = hn::Set(d, step.windy ? kUnwanted : kStillSteps);
    const hn::Mask<D> moving = hn::Lt(stillBefore, asleepFrom);
    const V ownLength = hn::LoadU(d, lanes + kSegmentLength * kLanes);
    const V length = hn::Add(ownLength, hn::Mul(ownLength, hn::LoadU(d, lanes + kStretch * kLanes)));

    predict(d, gains, step, rest, current, previous, lanes, p);
    const V tension = restoreLengths(d, gains.nodes, length, moving, p);
    swing(d, gains.nodes, moving, hn::Mul(tension, length), lanes);

    const V zero = hn::Zero(d);
    const V one = hn::Set(d, 1.0F);
    const V holdKeep = hn::LoadU(d, lanes + kHoldKeep * kLanes);
    const Vec3<V> lie = load3(d, lanes + kLieX * kLanes);
    const Vec3<V> root = load3(d, rest);
    hn::Mask<D> departed = hn::MaskFromVec(zero);
    Vec3<V> parent = root;
    store3(d, root, next);
    store3(d, root, previous);
    for (int i = 1; i < gains.nodes; ++i) {
        const std::size_t offset = static_cast<std::size_t>(i) * StrandBlocks::kNodeStride;
        const Vec3<V> start = load3(d, current + offset);
        Vec3<V> placed = atLength(d, parent, load3(d, p + offset), length, lie);
        Contact<D> contact = noContact(d);
        if (collide(d, colliders, step.neck, lanes, i == 1, parent, placed, contact)) {
            placed = rubbed(d, gains, contact, start, placed);
            placed = choose(contact.touched, atLength(d, parent, placed, length, lie), placed);
            Contact<D> second = noContact(d);
            if (collide(d, colliders, step.neck, lanes, i == 1, parent, placed, second))
                placed = choose(second.touched, atLength(d, parent, placed, length, lie), placed);
        }
        // Whatever went wrong (not a number, far away), the node goes back to where it was styled.
        const hn::Mask<D> lost = hn::Not(hn::Lt(dot(sub(placed, root), sub(placed, root)), hn::Set(d, 1e4F)));
        if (HWY_UNLIKELY(!hn::AllFalse(d, lost)))
            placed = choose(lost, load3(d, rest + offset), placed);

        const Vec3<V> onHead = sub(placed, start); // motion as the head sees it
        Vec3<V> velocity = step.toNewHead.identity ? onHead : sub(placed, moved(d, step.toNewHead, start));
        const V keep = hn::Mul(holdKeep, hn::Set(d, gains.rootKeep[static_cast<std::size_t>(i)]));
        velocity = sub(velocity, scale(onHead, hn::Sub(one, keep)));
        // In contact nothing moves into the surface or springs off it.
        if (!hn::AllFalse(d, contact.touched)) {
            const V across = hn::Div(dot(onHead, contact.normal), contact.normal2);
            const Vec3<V> sliding = sub(velocity, scale(contact.normal, hn::Mul(across, keep)));
            velocity = choose(contact.touched, sliding, velocity);
        }
        velocity = limited(d, choose(lost, Vec3<V>{zero, zero, zero}, velocity));
        placed = choose(moving, placed, start);
        store3(d, placed, next + offset);
        store3(d, choose(moving, sub(placed, velocity), placed), previous + offset);
        // Watching two places instead of speeds: a node that trembles where the hair leaves the head does not move.
        if (i == gains.nodes / 2)
            departed = hn::Or(departed, departedFrom(d, lanes + kMiddleX * kLanes, placed));
        if (i + 1 == gains.nodes)
            departed = hn::Or(departed, departedFrom(d, lanes + kTipX * kLanes, placed));
        parent = placed;
    }
    if (!hn::AllFalse(d, departed)) {
        remember(d, departed, next + static_cast<std::size_t>(gains.nodes / 2) * StrandBlocks::kNodeStride,
                 lanes + kMiddleX * kLanes);
        remember(d, departed, next + static_cast<std::size_t>(gains.nodes - 1) * StrandBlocks::kNodeStride,
                 lanes + kTipX * kLanes);
    }
    const V counted = hn::Add(stillBefore, one);
    const V still = step.windy ? zero : hn::IfThenZeroElse(departed, counted);
    hn::StoreU(hn::IfThenElse(moving, still, counted), d, lanes + kStill * kLanes);
}

void StepBlocks(const SolverBlocks& blocks, const GroupGains& gains, const ColliderSet& colliders,
                std::span<const StepForces> steps, int from, std::size_t begin, std::size_t end)
{
    const hn::CappedTag<float, kLanes> d;
    const std::size_t lanesAtOnce = hn::Lanes(d);
    HWY_ALIGN float scratch[std::size_t{kMostNodes} * StrandBlocks::kNodeStride];
    for (std::size_t block = begin; block < end; ++block) {
        const std::size_t first = block * static_cast<std::size_t>(gains.nodes) * StrandBlocks::kNodeStride;
        std::uint8_t awake = 0;
        for (std::size_t lane = 0; lane < kLanes; lane += lanesAtOnce) {
            float* const lanes = blocks.lanes + block * kLaneStride + lane;
            const std::size_t at = first + lane;
            auto read = static_cast<std::size_t>(from);
            for (const StepForces& step : steps) {
                // Asleep for two steps: both positions are the same, and nothing needs to be written.
                const auto done = hn::Set(d, step.windy ? kUnwanted : kStillSteps + 2.0F);
                if (!hn::AllTrue(d, hn::Ge(hn::LoadU(d, lanes + kStill * kLanes), done)))
                    stepStrands(d, gains, colliders, step, blocks.rest + at, blocks.positions[read] + at,
                                blocks.positions[1 - read] + at, blocks.previous + at, lanes, scratch);
                read = 1 - read;
            }
            const auto asleep = hn::Ge(hn::LoadU(d, lanes + kStill * kLanes), hn::Set(d, kStillSteps + 2.0F));
            awake = static_cast<std::uint8_t>(awake | (hn::AllTrue(d, asleep) ? 0 : 1));
        }
        blocks.awake[block] = awake;
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
