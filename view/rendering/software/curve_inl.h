// The drawn curve of as many strands as there are lanes, by sim/groom/curve_formula.inl, as sim/groom/strand_curve.h
// for one.
#if defined(HAIRPAINT_RENDERING_CURVE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_RENDERING_CURVE_INL_H_
#undef HAIRPAINT_RENDERING_CURVE_INL_H_
#else
#define HAIRPAINT_RENDERING_CURVE_INL_H_
#endif

#include "sim/groom/strand_curve.h"
#include "view/rendering/light/lanes_inl.h"
#include "view/rendering/software/strand_block.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::rendering::HWY_NAMESPACE {

inline constexpr float kNodeTolerance = 1e-3F; ///< Tolerance of comparisons with a node's number.

/// The formula for as many strands as there are lanes.
namespace of_lanes {

using namespace sim; // The curve's constants.
using Num = Lanes;
using Vec3 = Triple<Lanes>;
using Flag = Yes;

HWY_INLINE bool everywhere(Yes flag)
{
    return all(flag);
}
HWY_INLINE Lanes over(Lanes x, float constant)
{
    return x * Lanes(1.0F / constant);
}
HWY_INLINE Vec3 vec3Of(Lanes x, Lanes y, Lanes z)
{
    return {x, y, z};
}
HWY_INLINE Vec3 unitOf(const Vec3& v, Lanes squared)
{
    return v * (Lanes(1.0F) / root(most(squared, 1e-20F)));
}
HWY_INLINE Vec3 reflectedIn(const Vec3& v, const Vec3& axis, Lanes squared)
{
    return v - axis * (dot(axis, v) * (Lanes(2.0F) / most(squared, 1e-16F)));
}

#define CURVE_FUNCTION HWY_INLINE
#include "sim/groom/curve_formula.inl"
#include "sim/groom/fibre_formula.inl"
#undef CURVE_FUNCTION

} // namespace of_lanes

/// At fraction q of a braid of `lengthM`: along the frame's first axis, the strand, and the third.
HWY_INLINE Triple<Lanes> braidedOffset(const StrandBlock& block, std::size_t lane, Lanes q, Lanes lengthM)
{
    return of_lanes::braidedOffset({.radiusM = loaded(block.braidRadiusM.data() + lane),
                                    .turns = loaded(block.braidTurns.data() + lane),
                                    .begun = loaded(block.phase.data() + lane),
                                    .wispX = loaded(block.wispX.data() + lane),
                                    .wispY = loaded(block.wispY.data() + lane),
                                    .chance = loaded(block.variation.data() + lane),
                                    .taper = loaded(block.braidTaper.data() + lane),
                                    .tied = loaded(block.braidTied.data() + lane)},
                                   loaded(block.braid.data() + lane), loaded(block.wisp.data() + lane), q, lengthM);
}

/// At fraction s of the hairs, m: along the frame's first axis and the second.
HWY_INLINE Triple<Lanes> coilOffset(const StrandBlock& block, std::size_t lane, Lanes s)
{
    const sim::CurlSettings& coils = *block.coils;
    return of_lanes::coilOffset(
        {.turns = loaded(block.turns.data() + lane),
         .radiusM = loaded(block.curlRadiusM.data() + lane),
         .phase = loaded(block.phase.data() + lane),
         .chance = loaded(block.variation.data() + lane),
         .lengthM = loaded(block.lengthM.data() + lane) * (Lanes(1.0F) - loaded(block.braidStart.data() + lane))},
        {.inStepFromM = Lanes(coils.inStepFromM),
         .switchbacksPerM = Lanes(coils.switchbacksPerM),
         .skips = Lanes(coils.skips),
         .flatness = Lanes(coils.flatness),
         .uncoil = Lanes(coils.uncoil),
         .straightM = Lanes(coils.straightM)},
        s);
}

/// Writes spans.total + 1 points [point][3][kMostLanes] of the lanes from `lane` on, Wo.
HWY_INLINE void evaluateCurves(const StrandBlock& block, const SpanSegments& spans, std::size_t lane, float* pointsWo)
{
    constexpr std::size_t kRow = 3 * kMostLanes;
    const float* nodesWo = block.nodesWo.data() + lane;
    const int nodes = block.nodes;
    const auto node = [&](int k) { return loaded3(nodesWo + static_cast<std::size_t>(k) * kRow); };
    const Triple<Lanes> rootTangent = loaded3(block.tangentWo.data() + lane);
    int k = 0;
    Triple<Lanes> p1 = node(0);
    Triple<Lanes> p2 = node(1);
    Triple<Lanes> p0 = of_lanes::beyond(p1, p2);
    Triple<Lanes> p3 = nodes > 2 ? node(2) : of_lanes::beyond(p2, p1);
    if (block.anyTaut)
        p0 = select(loaded(block.taut.data() + lane) > Lanes(0.5F), of_lanes::beyondBent(p1, p2, p3), p0);
    Triple<Lanes> lastPoint = p1;
    Triple<Lanes> lastTangent = unit(p2 - p0);
    Triple<Lanes> reference = lastTangent;
    if (block.anyFrame)
        reference = of_lanes::across(rootTangent, lastTangent);
    const float perSpan = 1.0F / static_cast<float>(nodes - 1);
    for (int j = 0, first = 0; j <= spans.total; ++j) {
        while (j - first == spans.of[static_cast<std::size_t>(k)] && k + 2 < nodes) {
            first = j;
            ++k;
            p0 = p1;
            p1 = p2;
            p2 = p3;
            p3 = k + 2 < nodes ? node(k + 2) : of_lanes::beyond(p2, p1);
        }
        const float along = spans.along(k, nodes, j - first);
        const float s = (static_cast<float>(k) + along) * perSpan;
        const Lanes t(along);
        const of_lanes::Span span = of_lanes::spanOf(p0, p1, p2, p3);
        Triple<Lanes> point = of_lanes::positionAt(span, t);
        if (block.anyFrame) {
            const Triple<Lanes> derivative = of_lanes::derivativeAt(span, t);
            const Triple<Lanes> tangent = of_lanes::tangentOf(derivative, lastTangent);
            reference = of_lanes::carried(reference, lastPoint, lastTangent, point, tangent);
            lastPoint = point;
            lastTangent = tangent;
            const Triple<Lanes> axis = point;
            Yes braided{};
            if (block.anyBraid) {
                const Lanes start = loaded(block.braidStart.data() + lane);
                // The node from which on all hairs of a braid run alike.
                const Lanes shared = start * Lanes(static_cast<float>(nodes - 1)) + Lanes(1.0F);
                const Lanes at(static_cast<float>(k) + along);
                const Lanes gathered = at - shared + Lanes(2.0F);
                braided = (loaded(block.braid.data() + lane) > Lanes(0.5F)) & (gathered > Lanes(0.0F));
                const Lanes q = of_lanes::braidFraction(Lanes(s), start);
                const Lanes braidM = of_lanes::braidLength(root(dot(derivative, derivative)),
                                                           Lanes(static_cast<float>(nodes - 1)), start);
                const Triple<Lanes> offset = braidedOffset(block, lane, q, braidM) * of_lanes::gatheredPart(gathered);
                const Triple<Lanes> projected = of_lanes::across(rootTangent, tangent);
                const Yes isBefore = at < shared - Lanes(kNodeTolerance);
                if (along == 0.0F || j == spans.total)
                    reference = select(braided & (at < shared + Lanes(kNodeTolerance)), projected, reference);
                const Triple<Lanes> first = select(isBefore, projected, reference);
                point = select(braided, axis + first * offset.x + tangent * offset.y + cross(first, tangent) * offset.z,
                               axis);
            }
            if (block.anyCurl && block.coils != nullptr) {
                const Lanes curledS = of_lanes::curledFraction(Lanes(s), loaded(block.braidStart.data() + lane));
                const Triple<Lanes> offset = coilOffset(block, lane, curledS);
                const Triple<Lanes> curled = axis + reference * offset.x + cross(tangent, reference) * offset.y;
                point = block.anyBraid ? select(braided, point, curled) : curled;
            } else if (block.anyCurl) {
                const Lanes curledS = of_lanes::curledFraction(Lanes(s), loaded(block.braidStart.data() + lane));
                const Lanes angle =
                    of_lanes::curlAngle(loaded(block.phase.data() + lane), loaded(block.turns.data() + lane), curledS);
                const Triple<Lanes> offset = of_lanes::curlOffset(angle);
                const Lanes r = of_lanes::curlRadius(loaded(block.curlRadiusM.data() + lane), curledS);
                const Triple<Lanes> curled =
                    axis + (reference * offset.x + cross(tangent, reference) * offset.y + tangent * offset.z) * r;
                point = block.anyBraid ? select(braided, point, curled) : curled;
            }
            if (block.anyFrizz) {
                const of_lanes::Frizz frizz{.radiusM = loaded(block.frizzM.data() + lane),
                                            .waveRad = loaded(block.frizzRad.data() + lane)};
                const Triple<Lanes> offset =
                    of_lanes::frizzOffset(frizz, loaded(block.variation.data() + lane), Lanes(s));
                point = point + reference * offset.x + cross(tangent, reference) * offset.y;
            }
        }
        stored3(point, pointsWo + static_cast<std::size_t>(j) * kRow + lane);
    }
}

} // namespace hairpaint::rendering::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
