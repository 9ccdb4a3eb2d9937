// Sixteen strands at a time.
#include "view/rendering/software/strand_kernel.h"

#include "view/rendering/drawn_fraction.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "view/rendering/software/strand_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include "view/rendering/light/hair_light_inl.h"
#include "view/rendering/light/lanes_inl.h"
#include "view/rendering/light/tone_inl.h"
#include "view/rendering/software/curve_inl.h"
#include "view/rendering/software/grid_lookup_inl.h"
#include "view/rendering/software/head_occlusion_inl.h"
#include <algorithm>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hairpaint::rendering::HWY_NAMESPACE {

constexpr float kDeepFrom = 0.3F;       ///< Coverings of hair in front from which on fewer hairs are drawn,
constexpr float kDeepTo = 1.6F;         ///< and from which on StrandView::deepFraction of them are.
constexpr float kLeastShade = 0.05F;    ///< Coverings above which the eye's grid is read again, out of the coat.
constexpr float kGreatestWidth = 24.0F; ///< Greatest width, samples: wider strands would look like straw.
constexpr float kMostSlant = 1.42F;
constexpr float kSureDepths = 2.0F; ///< Depths behind the head from which on rounding leaves nothing in front of it.
constexpr int kMostJoinedSpans = 4; ///< Most spans in one segment: light is computed at its ends only.
constexpr float kNearestDrawnM = 0.01F;
constexpr float kSegmentsOfDyedSpan = 4.0F; ///< Segments of a span in which the tip colour begins or becomes whole.
/// Waves of frizz that segments follow, over those of the coarser wave, which has a little more than half the height.
constexpr float kFollowedWaves = 0.5F * (1.0F + sim::kFrizzFiner);

static_assert(kMostLanes == kBlockLanes);

/// Positions in clip space without z.
HWY_INLINE Triple<Lanes> projected(const glm::mat4& m, const Triple<Lanes>& p, float homogeneous)
{
    const auto row = [&](int r) {
        return p.x * Lanes(m[0][r]) + p.y * Lanes(m[1][r]) + p.z * Lanes(m[2][r]) + Lanes(m[3][r] * homogeneous);
    };
    return {row(0), row(1), row(3)};
}

HWY_INLINE Lanes biggest(Lanes a)
{
    return Lanes(hn::MaxOfLanes(Tag(), a.v));
}

/// SpanSegments::tipAlong: above 0 where a last segment as long as its span would thin out over too much, and the hair
/// is straight enough there.
float tipAlongOf(const StrandView& view, const StrandBlock& block, const SpanSegments& segments,
                 const std::array<float, kMostNodes>& bendAt)
{
    const auto spans = static_cast<std::size_t>(block.nodes) - 1;
    if (!view.tapers || spans < 3 || segments.of.at(spans - 1) != 1 || segments.of.at(spans - 2) == 0)
        return 0.0F;
    constexpr float kTwoSpans = 4.0F; // Distance between chord and curve of two spans, over that of one.
    if (kTwoSpans * std::max(bendAt.at(spans - 1), bendAt.at(spans - 2)) > 8.0F * view.toleranceSp)
        return 0.0F;
    float taper = 0.0F; // Sum of the strands' tapers, in spans.
    float strands = 0.0F;
    for (std::size_t lane = 0; lane < kMostLanes; ++lane)
        if (block.width[lane] > 0.0F) {
            taper += static_cast<float>(spans) / block.perTaper[lane];
            strands += 1.0F;
        }
    return std::max(1.0F - taper / std::max(strands, 1.0F), 0.0F);
}

/// Whether the tip colour begins, or becomes whole, between two fractions of any of the strands.
bool bendsWithin(const StrandBlock& block, float from, float to)
{
    const std::size_t mixes = block.anyTipStart ? kMostLanes : 1;
    for (std::size_t lane = 0; lane < mixes; ++lane)
        if (sim::TipMix{.scale = block.tipScale[lane], .offset = block.tipOffset[lane]}.bendsWithin(from, to))
            return true;
    return false;
}

void segmentsForAll(const StrandView& view, const StrandBlock& block, SpanSegments& segments)
{
    constexpr std::size_t kRow = 3 * kMostLanes;
    std::array<float, kMostNodes> bendAt{}; // [nodes] greatest second difference of the strands' nodes, samples.
    float turnSegments = 0.0F;
    for (std::size_t lane = 0; lane < kMostLanes; lane += hn::Lanes(Tag())) {
        const float* nodes = block.nodesWo.data() + lane;
        const Yes there = loaded(block.width.data() + lane) > Lanes(0.0F);
        Triple<Lanes> before = loaded3(nodes);
        Triple<Lanes> here = loaded3(nodes + kRow);
        const auto perM = [&](const Triple<Lanes>& position) {
            return Lanes(view.samplesPerM) /
                   most(projected(view.projectionFromWo, position, 1.0F).z, Lanes(kNearestDrawnM));
        };
        for (int k = 1; k + 1 < block.nodes; ++k) {
            const Triple<Lanes> after = loaded3(nodes + static_cast<std::size_t>(k + 1) * kRow);
            const Triple<Lanes> second = before - here - here + after;
            const Lanes bend = root(dot(second, second)) * perM(here);
            float& most = bendAt.at(static_cast<std::size_t>(k));
            most = std::max(most, hn::GetLane(biggest(select(there, bend, Lanes(0.0F))).v));
            before = here;
            here = after;
        }
        if (block.anyFrame) {
            // The chord of an nth of a circle lies r (pi/n)^2 / 2 inside it.
            const Lanes scale = perM(before) * Lanes(0.5F / view.toleranceSp);
            const Lanes curlR = loaded(block.curlRadiusM.data() + lane);
            Lanes wanted = loaded(block.turns.data() + lane) * most(root(curlR * scale) * Lanes(3.1416F), Lanes(4.0F));
            const Lanes behindStart = most(Lanes(1.0F) - loaded(block.braidStart.data() + lane), Lanes(0.1F));
            wanted = select(curlR > Lanes(0.0F), wanted / behindStart, Lanes(0.0F));
            const Lanes braid = root(loaded(block.braidRadiusM.data() + lane) * scale);
            // Flat plaits swing more often.
            const Lanes kind = loaded(block.braid.data() + lane);
            const Lanes swings = select((kind > Lanes(3.5F)) & (kind < Lanes(5.5F)), Lanes(2.0F), Lanes(1.0F));
            const Lanes plaited = loaded(block.braidTurns.data() + lane) * swings *
                                  most(braid * Lanes(2.0F * 3.1416F), Lanes(16.0F)) / behindStart;
            if (block.anyFrizz) // Frizz of less than a sample needs few segments.
                wanted =
                    most(wanted, loaded(block.frizzRad.data() + lane) *
                                     root(loaded(block.frizzM.data() + lane) * scale) * Lanes(0.5F * kFollowedWaves));
            wanted = most(wanted, select(loaded(block.braid.data() + lane) > Lanes(0.5F), plaited, Lanes(0.0F)));
            turnSegments = std::max(turnSegments, hn::GetLane(biggest(select(there, wanted, Lanes(0.0F))).v));
        }
    }
    const int spans = block.nodes - 1;
    const float turnsOfSpan = std::floor(turnSegments / static_cast<float>(spans) + 0.6F);
    // A run of n spans whose curve has second differences up to d lies n^2 d/8 beside its chord.
    const bool isPlain = !bendsWithin(block, 0.0F, 1.0F);
    int run = 1;
    float bendOfRun = 0.0F;
    segments.total = 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(spans); ++k) {
        const float bend = std::max(bendAt.at(k), bendAt.at(k + 1));
        const bool isDyed = !isPlain && bendsWithin(block, static_cast<float>(k) / static_cast<float>(spans),
                                                    static_cast<float>(k + 1) / static_cast<float>(spans));
        const float wanted = std::max(
            {std::ceil(std::sqrt(bend / (8.0F * view.toleranceSp))), turnsOfSpan, isDyed ? kSegmentsOfDyedSpan : 0.0F});
        segments.of.at(k) = static_cast<int>(std::clamp(wanted, 1.0F, static_cast<float>(kMostOfSpan)));
        const auto longer = static_cast<float>((run + 1) * (run + 1));
        bendOfRun = std::max(bendOfRun, bendAt.at(k));
        const bool joins = isPlain && run < kMostJoinedSpans && longer * bendOfRun <= 8.0F * view.toleranceSp &&
                           k > 0 && k + 1 < static_cast<std::size_t>(spans) && turnsOfSpan < 1.0F &&
                           segments.of.at(k) == 1 && segments.of.at(k - 1) <= 1;
        if (joins)
            segments.of.at(k) = 0;
        run = joins ? run + 1 : 1;
        bendOfRun = joins ? bendOfRun : 0.0F;
        segments.total += segments.of.at(k);
    }
    segments.tipAlong = tipAlongOf(view, block, segments, bendAt);
}

/// Square root of light / kMostLight in 10 bits.
HWY_INLINE Ints tenBits(Lanes light)
{
    const Lanes part = clamped(light * Lanes(1.0F / kMostLight), 0.0F, 1.0F);
    return hn::ConvertTo(IntTag(), (root(part) * Lanes(1023.0F) + Lanes(0.5F)).v);
}

/// Factor on a hair's width where it stands for others that are not drawn. Hairs of high order thin out to nothing, so
/// that none appears or vanishes at once.
HWY_INLINE Lanes wideningOf(const StrandView& view, Lanes order, Lanes towardEye)
{
    const Lanes fraction = mixed(Lanes(view.fraction), Lanes(view.fraction * view.deepFraction),
                                 smoothStep(kDeepFrom, kDeepTo, towardEye));
    const Lanes kept = clamped((Lanes(1.0F + kFadingPart) - order / fraction) * Lanes(1.0F / kFadingPart), 0.0F, 1.0F);
    return kept / least(fraction * Lanes(1.0F + 0.5F * kFadingPart), Lanes(1.0F));
}

/// Greatest factor that wideningOf() gives.
float mostWidening(const StrandView& view)
{
    const float fraction = view.fraction * std::min(view.deepFraction, 1.0F);
    return 1.0F / std::min(fraction * (1.0F + 0.5F * kFadingPart), 1.0F);
}

/// A point as the picture has it.
struct ScreenPoint
{
    Lanes across, up; ///< -1..1 in the picture.
    Lanes awayM;      ///< Along the view,
    Lanes perAway;    ///< and 1 over it.
    Lanes x, y;       ///< Samples.
    Lanes depth;      ///< 0..65535
};

HWY_INLINE ScreenPoint onScreen(const StrandView& view, const Triple<Lanes>& wo)
{
    const Triple<Lanes> clip = projected(view.projectionFromWo, wo, 1.0F);
    ScreenPoint point;
    point.awayM = clip.z;
    point.perAway = Lanes(1.0F) / most(clip.z, Lanes(kNearestDrawnM));
    point.across = clip.x * point.perAway;
    point.up = clip.y * point.perAway;
    point.x = (point.across * Lanes(0.5F) + Lanes(0.5F)) * Lanes(view.sizeSp.x);
    point.y = (point.up * Lanes(0.5F) + Lanes(0.5F)) * Lanes(view.sizeSp.y);
    point.depth = clamped((clip.z - Lanes(view.nearestM)) * Lanes(view.depthsPerM), 0.0F, 65535.0F);
    return point;
}

/// False where a segment surely lies beside the picture or behind the head. `widest`: no less than its width at a
/// distance of 1 m, samples.
HWY_INLINE Yes mayBeSeen(const StrandView& view, const ScreenPoint& a, const ScreenPoint& b, Lanes widest)
{
    const Lanes width = least(widest * most(a.perAway, b.perAway), Lanes(kGreatestWidth)) * Lanes(kMostSlant);
    const Lanes reach = Lanes(1.0F) + width * Lanes(0.5F);
    const ScreenBox box{.lowX = least(a.x, b.x) - reach,
                        .lowY = least(a.y, b.y) - reach,
                        .highX = most(a.x, b.x) + reach,
                        .highY = most(a.y, b.y) + reach};
    const Yes beside = (box.highX <= Lanes(0.0F)) | (box.highY <= Lanes(0.0F)) | (box.lowX >= Lanes(view.sizeSp.x)) |
                       (box.lowY >= Lanes(view.sizeSp.y));
    if (view.head.beyondM == nullptr)
        return !beside;
    const Lanes beyond = (hiddenBeyondM(view.head, box, view.sizeSp) - Lanes(view.nearestM)) * Lanes(view.depthsPerM);
    return !(beside | (least(a.depth, b.depth) > beyond + Lanes(kSureDepths)));
}

/// A bit a lane.
HWY_INLINE std::uint32_t bitsOf(Yes yes)
{
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(Tag(), yes.m, bytes);
    return static_cast<std::uint32_t>(bytes[0]) | static_cast<std::uint32_t>(bytes[1]) << 8U;
}

void pointsOfLanes(const StrandView& view, const StrandBlock& block, const SpanSegments& spans, std::size_t lane,
                   StrandPoints& out)
{
    const int segments = spans.total;
    constexpr std::size_t kRow = 3 * kMostLanes;
    const IntTag di;
    evaluateCurves(block, spans, lane, out.pointsWo.data());
    const Lanes own = loaded(block.width.data() + lane) * Lanes(view.groupWidthM * view.samplesPerM);
    const Lanes variation = loaded(block.variation.data() + lane);
    const Lanes turned = turnedBy(variation);
    const Lanes order = loaded(block.order.data() + lane);
    const Lanes shine = loaded(block.shine.data() + lane);
    const Lanes sharpness = loaded(block.sharpness.data() + lane);
    const bool isFlat = view.sectionAxes > 1.0F;
    const Lanes perTaper = loaded(block.perTaper.data() + lane);
    const Lanes beforeTaper = Lanes(1.0F) - perTaper;
    const Lanes lightness = exp2Of(variation * Lanes(3.0F * view.variationScale));
    const auto colourOf = [&](const std::array<LaneRow, 3>& rows) {
        return Triple<Lanes>{linearFromSrgb(loaded(rows[0].data() + lane)),
                             linearFromSrgb(loaded(rows[1].data() + lane)),
                             linearFromSrgb(loaded(rows[2].data() + lane))} *
               lightness;
    };
    const Triple<Lanes> rootColour = colourOf(block.rootColour);
    const Triple<Lanes> tipColour = colourOf(block.tipColour);
    const Lanes tipScale = loaded(block.tipScale.data() + lane);
    const Lanes tipOffset = loaded(block.tipOffset.data() + lane);
    const Triple<Lanes> rootDepth = fibreDepth(rootColour); // Pigment fades evenly toward the tip.
    const Triple<Lanes> tipDepth = fibreDepth(tipColour);
    const Triple<Lanes> rootLight = lightShownAs(rootColour);
    const Triple<Lanes> tipLight = lightShownAs(tipColour);
    const float* pointsWo = out.pointsWo.data() + lane;
    const auto at = [&](int j) { return loaded3(pointsWo + static_cast<std::size_t>(j) * kRow); };
    const float before = kOutOfCoatVoxels / static_cast<float>(view.gridSide);
    const Lanes widest = own * Lanes(mostWidening(view) * std::max(view.rootAlpha, view.tipAlpha) *
                                     std::sqrt(std::max(view.sectionAxes, 1.0F)));
    Triple<Lanes> last = at(0);
    Triple<Lanes> here = last;
    Triple<Lanes> next = last;
    ScreenPoint screenNext = onScreen(view, next);
    Yes segmentNext = noLane();
    const auto step = [&] {
        last = here;
        here = next;
    };
    for (int j = 0; j <= segments; ++j, step()) {
        const std::size_t row = static_cast<std::size_t>(j) * kMostLanes + lane;
        const ScreenPoint screen = screenNext;
        stored(screen.x, out.x.data() + row);
        stored(screen.y, out.y.data() + row);
        stored(screen.depth, out.depth.data() + row);
        Yes wanted = segmentNext; // An end of a segment that may be seen.
        if (j < segments) {
            next = at(j + 1);
            screenNext = onScreen(view, next);
            segmentNext = mayBeSeen(view, screen, screenNext, widest);
            wanted = wanted | segmentNext;
            std::uint32_t& bits = out.mayBeSeen[static_cast<std::size_t>(j)];
            bits = (lane > 0 ? bits : 0U) | bitsOf(segmentNext) << lane;
        }
        if (!any(wanted)) {
            stored(Lanes(0.0F), out.width.data() + row);
            continue;
        }

        // What hides hair half lies nearer than what shades it.
        const Triple<Lanes> toEye = inEyeGrid(view.eyeGrid, screen.across, screen.up, screen.awayM, before);
        const OpacityTwice eyeward = opacityTwice(view.opacity[1], view.gridSide, toEye);
        const Lanes spread = own * wideningOf(view, order, eyeward.further);
        const Yes seen = wanted & (screen.awayM > Lanes(kNearestDrawnM)) &
                         (Lanes(view.undrawnCoverings) > (view.inEveryColumn ? eyeward.inEveryColumn : eyeward.here)) &
                         (spread > Lanes(0.0F));
        if (!any(seen)) {
            stored(Lanes(0.0F), out.width.data() + row);
            continue;
        }
        const Triple<Lanes> toLight = outOfCoat(inGrid(view.gridFromWo, here, before), view.coatAxes[0], view.gridSide);
        const Lanes towardLight = opacityAt(view.opacity[0], view.gridSide, toLight);
        // Out of the coat there may be less, not more.
        Lanes towardEye = eyeward.here;
        const Yes shaded = towardEye > Lanes(kLeastShade);
        if (any(shaded)) {
            const Triple<Lanes> outside = outOfCoat(toEye, view.coatAxes[1], view.gridSide);
            const Lanes moved = most(magnitude(outside.x - toEye.x), magnitude(outside.y - toEye.y));
            const Yes steep = shaded & (moved > Lanes(0.0F)); // What faces the eye stays.
            if (any(steep))
                towardEye =
                    select(steep, least(towardEye, opacityAt(view.opacity[1], view.gridSide, outside)), towardEye);
        }
        const float s = out.fraction[static_cast<std::size_t>(j)];
        const Triple<Lanes> tangent = unit(next - last);

        // Thickness is measured across the walk's main direction, so slanted strands need more.
        const Triple<Lanes> clipAlong = projected(view.projectionFromWo, tangent, 0.0F);
        const Lanes alongX = (clipAlong.x - screen.across * clipAlong.z) * Lanes(view.sizeSp.x);
        const Lanes alongY = (clipAlong.y - screen.up * clipAlong.z) * Lanes(view.sizeSp.y);
        const Lanes squareX = alongX * alongX;
        const Lanes squareY = alongY * alongY;
        const Lanes slant = root((squareX + squareY) / most(most(squareX, squareY), Lanes(1e-20F)));
        const Lanes thinning = most(Lanes(s) * perTaper + beforeTaper, Lanes(0.0F));
        const Lanes alpha = Lanes(view.rootAlpha) + Lanes(view.tipAlpha - view.rootAlpha) * thinning * thinning;
        of_lanes::Section section{.width = Lanes(1.0F), .glint = Lanes(1.0F), .lean = Lanes(0.0F)};
        if (isFlat)
            section = of_lanes::sectionAt(Lanes(view.sectionAxes), loaded(block.turns.data() + lane),
                                          loaded(block.lengthM.data() + lane), loaded(block.phase.data() + lane),
                                          variation, Lanes(s));
        const Lanes width = least(spread * screen.perAway * alpha * section.width, Lanes(kGreatestWidth)) *
                            least(slant, Lanes(kMostSlant));
        stored(select(seen, width, Lanes(0.0F)), out.width.data() + row);

        const Lanes behind = most(columnAt(view.opacity[1], view.gridSide, toEye) - eyeward.here, Lanes(0.0F));
        const Lanes tip = clamped(Lanes(s) * tipScale + tipOffset, 0.0F, 1.0F);
        const Triple<Lanes> lit = hairLight(
            view.lighting, HairPoint<Lanes>{here, tangent, rootLight + (tipLight - rootLight) * tip,
                                            rootDepth + (tipDepth - rootDepth) * tip, turned + section.lean,
                                            towardLight, towardEye, behind, shine * section.glint, sharpness});
        const Ints packed =
            hn::Or(hn::Or(tenBits(lit.x), hn::ShiftLeft<10>(tenBits(lit.y))), hn::ShiftLeft<20>(tenBits(lit.z)));
        hn::StoreU(packed, di, reinterpret_cast<std::int32_t*>(out.colour.data()) + row);
    }
}

void pointsOfAll(const StrandView& view, const StrandBlock& block, const SpanSegments& segments, StrandPoints& out)
{
    for (std::size_t lane = 0; lane < kMostLanes; lane += hn::Lanes(Tag()))
        pointsOfLanes(view, block, segments, lane, out);
}

void curvesOfAll(const StrandBlock& block, const SpanSegments& segments, float* pointsWo)
{
    for (std::size_t lane = 0; lane < kMostLanes; lane += hn::Lanes(Tag()))
        evaluateCurves(block, segments, lane, pointsWo);
}

} // namespace hairpaint::rendering::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hairpaint::rendering {

HWY_EXPORT(segmentsForAll);
HWY_EXPORT(pointsOfAll);
HWY_EXPORT(curvesOfAll);

SpanSegments segmentsFor(const StrandView& view, const StrandBlock& block)
{
    SpanSegments segments;
    HWY_DYNAMIC_DISPATCH(segmentsForAll)(view, block, segments);
    return segments;
}

void drawnPoints(const StrandView& view, const StrandBlock& block, const SpanSegments& segments, StrandPoints& points)
{
    points.resize(static_cast<std::size_t>(segments.total) + 1);
    const float perSpan = 1.0F / static_cast<float>(block.nodes - 1);
    std::size_t point = 0;
    for (std::size_t k = 0; k + 1 < static_cast<std::size_t>(block.nodes); ++k)
        for (int j = 0; j < segments.of.at(k); ++j)
            points.fraction[point++] =
                (static_cast<float>(k) + segments.along(static_cast<int>(k), block.nodes, j)) * perSpan;
    points.fraction[point] = 1.0F;
    HWY_DYNAMIC_DISPATCH(pointsOfAll)(view, block, segments, points);
}

void drawnCurves(const StrandBlock& block, const SpanSegments& segments, float* pointsWo)
{
    HWY_DYNAMIC_DISPATCH(curvesOfAll)(block, segments, pointsWo);
}

} // namespace hairpaint::rendering
#endif
