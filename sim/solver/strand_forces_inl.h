// What moves a strand's nodes before its lengths and contacts are restored: inertia, drag, gravity, wind, stiffness.
// Compiled once for each instruction set. As vec3_inl.h: the same bytes with each.
#if defined(HAIRPAINT_SIM_STRAND_FORCES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_SIM_STRAND_FORCES_INL_H_
#undef HAIRPAINT_SIM_STRAND_FORCES_INL_H_
#else
#define HAIRPAINT_SIM_STRAND_FORCES_INL_H_
#endif

#include "sim/solver/strand_kernel_inl.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

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

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
