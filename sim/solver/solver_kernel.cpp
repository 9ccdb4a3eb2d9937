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

/// Fraction of a child's correction that its parent's velocity answers with (Mueller et al. 2012, section 3.3).
constexpr float kChildAnswer = 0.9F;
/// A node leaves an ellipsoid or the skin by at most this much in a step, m.
constexpr float kFastestLeaveM = 0.02F;
constexpr int kLengthIterations = 2;

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

/// The air around one strand: the wind's strength there, and its two waves of turbulence.
template<class D>
struct StrandAir
{
    Vec3<hn::Vec<D>> wind;
    hn::Vec<D> sinA, cosA, sinB, cosB;
};

template<class D>
HWY_INLINE StrandAir<D> airAround(D d, const GroupGains& gains, const StepForces& step, const float* HWY_RESTRICT lanes)
{
    const auto quarter = hn::Set(d, 1.5707963F);
    const auto gustWave = waveSin(d, hn::Sub(hn::LoadU(d, lanes + kPhaseGust * kLanes), hn::Set(d, step.phaseGust)));
    const auto half = hn::Set(d, 0.5F);
    const auto lull = hn::Mul(hn::Set(d, step.gust), hn::Sub(half, hn::Mul(half, gustWave)));
    const auto strength = hn::Mul(hn::Set(d, gains.windScale), hn::Sub(hn::Set(d, 1.0F), lull));
    const auto a = hn::Sub(hn::LoadU(d, lanes + kPhaseA * kLanes), hn::Set(d, step.phaseA));
    const auto b = hn::Sub(hn::LoadU(d, lanes + kPhaseB * kLanes), hn::Set(d, step.phaseB));
    return {scale(set3(d, step.wind), strength), waveSin(d, a), waveSin(d, hn::Add(a, quarter)), waveSin(d, b),
            waveSin(d, hn::Add(b, quarter))};
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
    auto wind = addScaled(air.wind, set3(d, step.swirlA), hn::Mul(waveA, hn::Set(d, gains.windScale)));
    wind = addScaled(wind, set3(d, step.swirlB), hn::Mul(waveB, hn::Set(d, gains.windScale)));
    for (int i = 0; i < step.puffCount; ++i) {
        const PuffForces& puff = step.puffs[static_cast<std::size_t>(i)];
        const auto away = sub(p, set3(d, puff.centre));
        const auto left =
            hn::Max(hn::Zero(d), hn::Sub(hn::Set(d, 1.0F), hn::Mul(dot(away, away), hn::Set(d, puff.inverseRadius2))));
        wind = addScaled(wind, set3(d, puff.velocity), hn::Mul(left, left));
    }
    return wind;
}

/// Equation 5 with drag, gravity, wind and the gains of the shape, into p: [nodes][3][kLanes].
template<class D>
HWY_INLINE void predict(D d, const GroupGains& gains, const StepForces& step, const float* HWY_RESTRICT rest,
                        const float* HWY_RESTRICT current, const float* HWY_RESTRICT previous,
                        const float* HWY_RESTRICT lanes, float* HWY_RESTRICT p)
{
    using V = hn::Vec<D>;
    const V drag = hn::Set(d, gains.drag);
    const V loose = hn::LoadU(d, lanes + kLoose * kLanes);
    const hn::Mask<D> held = hn::Lt(loose, hn::Set(d, 1.0F));
    const bool anyHeld = !hn::AllFalse(d, held);
    const V inverseSquare = hn::LoadU(d, lanes + kInverseSquare * kLanes);
    const Vec3<V> gravity = scale(set3(d, step.gravity), hn::Set(d, gains.gravityScale));
    const Vec3<V> lie = scale(load3(d, lanes + kLieX * kLanes), hn::LoadU(d, lanes + kSegmentLength * kLanes));
    StrandAir<D> air{};
    if (step.windy)
        air = airAround(d, gains, step, lanes);

    Vec3<V> parent = load3(d, rest); // predicted, and as it was with its own parent
    Vec3<V> before = load3(d, current);
    if (!step.toNewHead.identity)
        before = moved(d, step.toNewHead, before);
    Vec3<V> secondBefore = before;
    store3(d, parent, p);
    for (int i = 1; i < gains.nodes; ++i) {
        const auto node = static_cast<std::size_t>(i);
        const std::size_t offset = node * StrandBlocks::kNodeStride;
        Vec3<V> x = load3(d, current + offset);
        Vec3<V> last = load3(d, previous + offset);
        if (!step.toNewHead.identity) {
            x = moved(d, step.toNewHead, x);
            last = moved(d, step.toNewHead, last);
        }
        Vec3<V> v = scale(sub(x, last), drag);
        if (step.windy) {
            // -((t x r) x t) for the relative velocity r: only its part across the segment drags.
            const Vec3<V> edge = sub(x, before);
            const Vec3<V> relative = sub(airAt(d, air, gains, step, node, x), v);
            const V along = hn::Mul(dot(edge, relative), inverseSquare);
            const Vec3<V> across = sub(relative, scale(edge, along));
            v = addScaled(v, across, hn::Set(d, gains.windGain));
        }
        Vec3<V> next = add(add(x, v), gravity);
        if (i > 1 && gains.straighten > 0.0F) {
            const Vec3<V> straight = sub(add(before, before), secondBefore);
            next = addScaled(next, sub(straight, x), hn::Set(d, gains.straighten));
        }
        if (gains.body[node] > 0.0F)
            next = addScaled(next, sub(add(parent, lie), next), hn::Set(d, gains.body[node]));
        if (anyHeld) {
            const Vec3<V> styled = load3(d, rest + offset);
            next = choose(held, addScaled(styled, sub(next, styled), loose), next);
        }
        store3(d, next, p + offset);
        parent = next;
        secondBefore = before;
        before = x;
    }
}

/// Equation 4 and algorithm 2: both ends of a segment move by half of what its length is wrong by, the root not at
/// all. Odd segments first, then even ones. Jakobsen's form without a square root.
template<class D>
HWY_INLINE void relaxLengths(D d, int nodes, hn::Vec<D> length, float* HWY_RESTRICT p)
{
    using V = hn::Vec<D>;
    const V square = hn::Mul(length, length);
    const V half = hn::Set(d, 0.5F);
    for (int first = 1; first <= 2; ++first) {
        for (int i = first; i < nodes; i += 2) {
            float* const childAt = p + static_cast<std::size_t>(i) * StrandBlocks::kNodeStride;
            float* const parentAt = childAt - StrandBlocks::kNodeStride;
            const Vec3<V> parent = load3(d, parentAt);
            const Vec3<V> child = load3(d, childAt);
            const Vec3<V> edge = sub(child, parent);
            const V fraction = hn::Sub(hn::Div(square, hn::Add(dot(edge, edge), square)), half);
            const Vec3<V> correction = scale(edge, fraction);
            if (i == 1) {
                store3(d, add(add(child, correction), correction), childAt);
            } else {
                store3(d, sub(parent, correction), parentAt);
                store3(d, add(child, correction), childAt);
            }
        }
    }
}

/// Keeps a node outside every ellipsoid, and it and its segment outside the skin; true where any lane was inside one.
template<class D>
HWY_INLINE bool collide(D d, const ColliderSet& colliders, const float* HWY_RESTRICT lanes, bool first,
                        const Vec3<hn::Vec<D>>& parent, Vec3<hn::Vec<D>>& p, Contact<D>& contact)
{
    bool any = false;
    for (int c = 0; c < colliders.count; ++c)
        any |= pushOut(d, colliders.items[static_cast<std::size_t>(c)], hn::LoadU(d, lanes + (kScale + c) * kLanes),
                       hn::Set(d, kFastestLeaveM), p, contact);
    if (colliders.skin.values != nullptr)
        any |= pushSegmentOutOfSkin(d, colliders.skin, hn::Set(d, kSkinClearanceM), hn::Set(d, kFastestLeaveM), first,
                                    parent, p, contact);
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
    const V length = hn::LoadU(d, lanes + kSegmentLength * kLanes);

    predict(d, gains, step, rest, current, previous, lanes, p);
    for (int i = 0; i < kLengthIterations; ++i)
        relaxLengths(d, gains.nodes, length, p);

    const V zero = hn::Zero(d);
    const V one = hn::Set(d, 1.0F);
    const V looseDrag = hn::LoadU(d, lanes + kLooseDrag * kLanes);
    const Vec3<V> lie = load3(d, lanes + kLieX * kLanes);
    const Vec3<V> root = load3(d, rest);
    hn::Mask<D> departed = hn::MaskFromVec(zero);
    Vec3<V> parent = root;
    store3(d, root, next);
    store3(d, root, previous);
    // The parent's velocity waits until its child's correction is known.
    Vec3<V> parentPosition = root;
    Vec3<V> parentVelocity{zero, zero, zero};
    hn::Mask<D> parentFree = hn::MaskFromVec(zero);
    for (int i = 1; i <= gains.nodes; ++i) {
        const std::size_t offset = static_cast<std::size_t>(i) * StrandBlocks::kNodeStride;
        const bool pastTip = i == gains.nodes;
        Vec3<V> placed = parent;
        Vec3<V> velocity = parentVelocity;
        hn::Mask<D> free = parentFree;
        if (!pastTip) {
            const Vec3<V> start = load3(d, current + offset);
            const Vec3<V> wished = load3(d, p + offset);
            placed = atLength(d, parent, wished, length, lie);
            const V answer = hn::IfThenElseZero(parentFree, hn::Set(d, kChildAnswer));
            parentVelocity = sub(parentVelocity, scale(sub(placed, wished), answer));

            Contact<D> contact = noContact(d);
            if (collide(d, colliders, lanes, i == 1, parent, placed, contact)) {
                placed = rubbed(d, gains, contact, start, placed);
                placed = choose(contact.touched, atLength(d, parent, placed, length, lie), placed);
                Contact<D> second = noContact(d);
                if (collide(d, colliders, lanes, i == 1, parent, placed, second))
                    placed = choose(second.touched, atLength(d, parent, placed, length, lie), placed);
            }
            // Whatever went wrong (not a number, far away), the node goes back to where it was styled.
            const hn::Mask<D> lost = hn::Not(hn::Lt(dot(sub(placed, root), sub(placed, root)), hn::Set(d, 1e4F)));
            if (HWY_UNLIKELY(!hn::AllFalse(d, lost)))
                placed = choose(lost, load3(d, rest + offset), placed);

            const Vec3<V> onHead = sub(placed, start); // motion as the head sees it
            velocity = step.toNewHead.identity ? onHead : sub(placed, moved(d, step.toNewHead, start));
            const V keep = hn::Mul(looseDrag, hn::Set(d, gains.bodyKeep[static_cast<std::size_t>(i)]));
            velocity = sub(velocity, scale(onHead, hn::Sub(one, keep)));
            // In contact nothing moves into the surface or springs off it.
            if (!hn::AllFalse(d, contact.touched)) {
                const V across = hn::Div(dot(onHead, contact.normal), contact.normal2);
                const Vec3<V> sliding = sub(velocity, scale(contact.normal, hn::Mul(across, keep)));
                velocity = choose(contact.touched, sliding, velocity);
            }
            velocity = choose(lost, Vec3<V>{zero, zero, zero}, velocity);
            free = hn::Not(contact.touched);
            placed = choose(moving, placed, start);
            store3(d, placed, next + offset);
            // Watching two places instead of speeds: a node that trembles where the hair leaves the head does not move.
            if (i == gains.nodes / 2)
                departed = hn::Or(departed, departedFrom(d, lanes + kMiddleX * kLanes, placed));
            if (i + 1 == gains.nodes)
                departed = hn::Or(departed, departedFrom(d, lanes + kTipX * kLanes, placed));
        }
        if (i > 1) {
            const Vec3<V> kept = limited(d, parentVelocity);
            const Vec3<V> last = sub(parentPosition, kept);
            store3(d, choose(moving, last, parentPosition), previous + offset - StrandBlocks::kNodeStride);
        }
        parent = placed;
        parentPosition = placed;
        parentVelocity = velocity;
        parentFree = free;
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
