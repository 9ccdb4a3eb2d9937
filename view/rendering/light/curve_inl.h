// The drawn curve of as many strands as there are lanes: sim/groom/strand_curve.h says the same for one.
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

inline constexpr float kTwoPi = 6.28318531F;
inline constexpr float kTinySquare = 1e-16F;
inline constexpr float kNodeTolerance = 1e-3F; ///< Of numbers of nodes.

/// `reference` at unit length in the plane across a unit tangent, or any vector there.
template<class F>
HWY_INLINE Triple<F> across(const Triple<F>& reference, const Triple<F>& tangent)
{
    const Triple<F> v = reference - tangent * dot(reference, tangent);
    const F square = dot(v, v);
    const auto degenerate = F(1e-8F) > square;
    if (!any(degenerate))
        return v * (F(1.0F) / root(square));
    const auto steep = least(tangent.x * tangent.x, F(0.49F)) < F(0.49F);
    const Triple<F> axis{select(steep, F(1.0F), F(0.0F)), select(steep, F(0.0F), F(1.0F)), F(0.0F)};
    const Triple<F> other = axis - tangent * dot(axis, tangent);
    const Triple<F> chosen = select(degenerate, other, v);
    return chosen * (F(1.0F) / root(most(dot(chosen, chosen), F(1e-20F))));
}

/// One step of the double reflection: carries `reference` from one point and tangent to the next.
template<class F>
HWY_INLINE Triple<F> carried(const Triple<F>& reference, const Triple<F>& lastPoint, const Triple<F>& lastTangent,
                             const Triple<F>& point, const Triple<F>& tangent)
{
    const Triple<F> step = point - lastPoint;
    const F square = dot(step, step);
    const F per = F(2.0F) / most(square, F(kTinySquare));
    const Triple<F> reflected = reference - step * (dot(step, reference) * per);
    const Triple<F> reflectedTangent = lastTangent - step * (dot(step, lastTangent) * per);
    const Triple<F> second = tangent - reflectedTangent;
    const F secondSquare = dot(second, second);
    const F secondPer = F(2.0F) / most(secondSquare, F(kTinySquare));
    const Triple<F> turned = reflected - second * (dot(second, reflected) * secondPer);
    return select(square > F(kTinySquare), select(secondSquare > F(kTinySquare), turned, reflected), reference);
}

/// At fraction q of a braid of `lengthM`: along the frame's first axis, the strand, and the third.
HWY_INLINE Triple<Lanes> braidedOffset(const StrandBlock& block, std::size_t lane, Lanes q, Lanes lengthM)
{
    const Lanes one(1.0F);
    const Lanes zero(0.0F);
    const Lanes kind = loaded(block.braid.data() + lane);
    const Lanes wisp = loaded(block.wisp.data() + lane);
    const Lanes turns = loaded(block.braidTurns.data() + lane);
    const Yes isLoc = kind > Lanes(2.5F);
    const Yes isTwist = (kind > Lanes(1.5F)) & (kind < Lanes(2.5F));
    const Lanes parted = least(q * turns * Lanes(1.0F / sim::kBraidEaseTurns), one);
    const Lanes tuft =
        select(isLoc, zero, most(q - Lanes(1.0F - sim::kTuftFraction), zero) * Lanes(1.0F / sim::kTuftFraction));
    const Lanes tie = clamped(
        (q - Lanes(1.0F - sim::kTuftFraction - sim::kTieFraction)) * Lanes(1.0F / sim::kTieFraction), 0.0F, 1.0F);
    const Lanes tied = select(isLoc, zero, tie * tie * (Lanes(3.0F) - tie * Lanes(2.0F)));
    const Lanes r = loaded(block.braidRadiusM.data() + lane) * mixed(Lanes(sim::kBraidFirstFraction), one, parted);
    const Lanes angle = (turns * q + wisp * select(isTwist, Lanes(0.5F), Lanes(1.0F / 3.0F))) * Lanes(kTwoPi);
    const Lanes pathR = select(isLoc, zero, select(isTwist, Lanes(sim::kTwistFraction), one)) * r *
                        mixed(one, Lanes(sim::kTieBraidFraction), tied) * (one - tuft);
    const Lanes wispR = r *
                        select(isLoc, Lanes(sim::kLocWispFraction),
                               select(isTwist, Lanes(sim::kTwistWispFraction), Lanes(sim::kWispRadiusFraction))) *
                        (mixed(one, Lanes(sim::kTieWispFraction), tied) +
                         Lanes(sim::kTuftWispFraction - sim::kTieWispFraction) * tuft * (Lanes(2.0F) - tuft));
    const Lanes swing = select(isTwist, one, Lanes(2.0F)); // Of the third axis, for one of the first.
    // A hair's place in the wisp lies across the wisp's own path, so that wisps are round.
    const Lanes perFraction = pathR * turns * Lanes(kTwoPi);
    const Triple<Lanes> along = unit(Triple<Lanes>{zero - sinOf(angle) * perFraction, most(lengthM, Lanes(1e-6F)),
                                                   cosOf(angle * swing) * swing * perFraction});
    const Lanes aside = root(along.y * along.y + along.z * along.z);
    const Lanes wispX = loaded(block.wispX.data() + lane);
    const Lanes wispY = loaded(block.wispY.data() + lane);
    const Lanes x = wispX * wispR;
    const Lanes y = wispY * wispR;
    const Lanes shorter =
        lengthM * Lanes(sim::kTuftFraction * sim::kTuftUneven) * tuft * (wispX * wispX + wispY * wispY);
    // Along the braid they have the room that their number leaves; a loc is alone.
    const Lanes room =
        lengthM * select(isTwist, Lanes(sim::kTwistRoomTurns), Lanes(sim::kPlaitRoomTurns)) / most(turns, Lanes(1e-3F));
    const Lanes squash = least(one, room / most(wispR, Lanes(1e-6F)));
    return {cosOf(angle) * pathR + x * aside, zero - (x * along.x * along.y + y * along.z) / aside * squash - shorter,
            sinOf(angle * swing) * pathR + (y * along.y - x * along.x * along.z) / aside};
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
    Triple<Lanes> p0 = p1 + p1 - p2;
    Triple<Lanes> p3 = nodes > 2 ? node(2) : p2 + p2 - p1;
    Triple<Lanes> lastPoint = p1;
    Triple<Lanes> lastTangent = unit(p2 - p0);
    Triple<Lanes> reference = lastTangent;
    if (block.anyFrame)
        reference = across(rootTangent, lastTangent);
    const float perSpan = 1.0F / static_cast<float>(nodes - 1);
    for (int j = 0, first = 0; j <= spans.total; ++j) {
        while (j - first == spans.of[static_cast<std::size_t>(k)] && k + 2 < nodes) {
            first = j;
            ++k;
            p0 = p1;
            p1 = p2;
            p2 = p3;
            p3 = k + 2 < nodes ? node(k + 2) : p2 + p2 - p1;
        }
        const float along = static_cast<float>(j - first) / static_cast<float>(spans.of[static_cast<std::size_t>(k)]);
        const float s = (static_cast<float>(k) + along) * perSpan;
        const Lanes t(along);
        const Triple<Lanes> c1 = (p2 - p0) * Lanes(0.5F);
        const Triple<Lanes> c2 = p0 - p1 * Lanes(2.5F) + p2 * Lanes(2.0F) - p3 * Lanes(0.5F);
        const Triple<Lanes> c3 = (p3 - p0) * Lanes(0.5F) + (p1 - p2) * Lanes(1.5F);
        Triple<Lanes> point = p1 + (c1 + (c2 + c3 * t) * t) * t;
        if (block.anyFrame) {
            const Triple<Lanes> derivative = c1 + (c2 * Lanes(2.0F) + c3 * (t * Lanes(3.0F))) * t;
            const Lanes square = dot(derivative, derivative);
            const Triple<Lanes> tangent =
                select(square > Lanes(kTinySquare), derivative * (Lanes(1.0F) / root(most(square, Lanes(kTinySquare)))),
                       lastTangent);
            reference = carried(reference, lastPoint, lastTangent, point, tangent);
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
                const Lanes q = clamped((Lanes(s) - start) / most(Lanes(1.0F) - start, Lanes(1e-6F)), 0.0F, 1.0F);
                const Lanes braidM =
                    root(square) * Lanes(static_cast<float>(nodes - 1)) * most(Lanes(1.0F) - start, Lanes(1e-6F));
                const Triple<Lanes> offset = braidedOffset(block, lane, q, braidM) * least(gathered, Lanes(1.0F));
                const Triple<Lanes> projected = across(rootTangent, tangent);
                const Yes isBefore = at < shared - Lanes(kNodeTolerance);
                if (along == 0.0F || j == spans.total)
                    reference = select(braided & (at < shared + Lanes(kNodeTolerance)), projected, reference);
                const Triple<Lanes> first = select(isBefore, projected, reference);
                point = select(braided, axis + first * offset.x + tangent * offset.y + cross(first, tangent) * offset.z,
                               axis);
            }
            if (block.anyCurl) {
                const Lanes angle =
                    loaded(block.phase.data() + lane) + loaded(block.turns.data() + lane) * Lanes(kTwoPi * s);
                const Lanes c = cosOf(angle);
                const Lanes n = sinOf(angle);
                const Lanes r =
                    loaded(block.curlRadiusM.data() + lane) * Lanes(std::min(1.0F, s / sim::kCurlEaseFraction));
                const Triple<Lanes> curled =
                    axis + (reference * c + cross(tangent, reference) * n + tangent * (c * n)) * r;
                point = block.anyBraid ? select(braided, point, curled) : curled;
            }
        }
        stored3(point, pointsWo + static_cast<std::size_t>(j) * kRow + lane);
    }
}

} // namespace hairpaint::rendering::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
