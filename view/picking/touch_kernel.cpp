// Distances from the brush, and what hides, by vectors of the machine.
#include "view/picking/touch_kernel.h"

#include "view/picking/hair_boxes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "view/picking/touch_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include "view/picking/picking_lanes_inl.h"
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hairpaint::view::HWY_NAMESPACE {

struct Point
{
    Lanes x, y;
};
HWY_INLINE Point between(const Point& a, const Point& b, Lanes t)
{
    return {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t};
}
HWY_INLINE Lanes apartOf(const Point& a, const Point& b)
{
    const Lanes x = b.x - a.x;
    const Lanes y = b.y - a.y;
    return root(x * x + y * y);
}
HWY_INLINE Lanes fractionNearest(const Point& point, const Point& from, const Point& to)
{
    const Lanes x = to.x - from.x;
    const Lanes y = to.y - from.y;
    const Lanes square = x * x + y * y;
    const Lanes along = (point.x - from.x) * x + (point.y - from.y) * y;
    return select(square > Lanes(0.0F), clamped(along / square, 0.0F, 1.0F), Lanes(0.0F));
}

/// nearestOf() of picture_brush.h.
HWY_INLINE void nearestTo(const PictureBrush& brush, const Point& a, const Point& b, Lanes& fraction, Lanes& apart)
{
    const Point c{Lanes(brush.from.x), Lanes(brush.from.y)};
    if (brush.from == brush.to) {
        fraction = fractionNearest(c, a, b);
        apart = apartOf(between(a, b, fraction), c);
        return;
    }
    const Point d{Lanes(brush.to.x), Lanes(brush.to.y)};
    const auto apartAt = [&](Lanes t) {
        const Point point = between(a, b, t);
        return apartOf(point, between(c, d, fractionNearest(point, c, d)));
    };
    fraction = Lanes(0.0F);
    apart = apartAt(fraction);
    for (const Lanes t : {Lanes(1.0F), fractionNearest(c, a, b), fractionNearest(d, a, b)}) {
        const Lanes other = apartAt(t);
        fraction = select(other < apart, t, fraction);
        apart = least(other, apart);
    }
    const Point segment{b.x - a.x, b.y - a.y};
    const Point edge{d.x - c.x, d.y - c.y};
    const Lanes area = segment.x * edge.y - segment.y * edge.x;
    const Lanes along = ((c.x - a.x) * edge.y - (c.y - a.y) * edge.x) / area;
    const Lanes alongEdge = ((c.x - a.x) * segment.y - (c.y - a.y) * segment.x) / area;
    const Yes crosses = (magnitude(area) > Lanes(1e-9F)) & (along >= Lanes(0.0F)) & (along <= Lanes(1.0F)) &
                        (alongEdge >= Lanes(0.0F)) & (alongEdge <= Lanes(1.0F));
    fraction = select(crosses, along, fraction);
    apart = select(crosses, Lanes(0.0F), apart);
}

/// FrontHair::hides().
HWY_INLINE Yes hiddenByHair(const FrontHair::Depths& depths, const Lanes3& seen)
{
    const PictureBox& box = depths.box;
    const Yes inside = (seen.x >= Lanes(box.left)) & (seen.x <= Lanes(box.right)) & (seen.y >= Lanes(box.top)) &
                       (seen.y <= Lanes(box.bottom));
    const auto cellsFrom = [&](Lanes at, float from) {
        return asInts(onlyWhere(inside, (at - Lanes(from)) * Lanes(depths.perPx)));
    };
    const IntTag di;
    const Ints cell =
        hn::Add(hn::Mul(cellsFrom(seen.y, box.top), hn::Set(di, depths.across)), cellsFrom(seen.x, box.left));
    const Ints index = hn::Add(hn::ShiftLeft<1>(cell), hn::Set(di, 1));
    return inside & (seen.z > gatheredFrom(depths.cells, index) + Lanes(depths.seenM));
}

/// SkinDepths::hides().
HWY_INLINE Yes hiddenBySkin(const SkinDepths::Samples& samples, const Lanes3& seen)
{
    const Lanes x = seen.x * Lanes(samples.scale);
    const Lanes y = seen.y * Lanes(samples.scale);
    const Yes inside = (x >= Lanes(0.0F)) & (y >= Lanes(0.0F)) & (x < Lanes(static_cast<float>(samples.width - 1))) &
                       (y < Lanes(static_cast<float>(samples.height - 1)));
    const IntTag di;
    const Ints first =
        hn::Add(hn::Mul(asInts(onlyWhere(inside, y)), hn::Set(di, samples.width)), asInts(onlyWhere(inside, x)));
    const float* below = samples.depths + samples.width;
    const Lanes furthest = least(least(gatheredFrom(samples.depths, first), gatheredFrom(samples.depths + 1, first)),
                                 least(gatheredFrom(below, first), gatheredFrom(below + 1, first)));
    return inside & (furthest > Lanes(0.0F)) & (seen.z > Lanes(1.0F) / furthest + Lanes(kOnSkinM));
}

/// What is found of strands, root first.
struct LaneTouches
{
    Lanes node, fraction, apart, stray, firstNode, firstFraction, lastNode;
    Yes found;
};

HWY_INLINE void touchFrom(const Lens& lens, const BlockQuestion& question, const PictureBrush& brush,
                          const BrushCover& cover, std::size_t lane, BlockTouches& touches)
{
    const FrontHair::Depths front = cover.front.depths();
    const SkinDepths::Samples skin = cover.skin.samples();
    const Lanes strayM = loaded(question.straysM + lane);
    PickRow counted{};
    for (std::size_t i = 0; i < kPickLanes; ++i)
        counted[i] = (question.lanes >> i & 1U) != 0 ? 1.0F : 0.0F;
    const Yes counts = loaded(counted.data() + lane) > Lanes(0.0F);
    const auto isAsked = [&](std::size_t segment) {
        return (question.spans >> (segment / HairBoxes::kSpan) & 1U) != 0;
    };
    const Lanes none(0.0F);
    LaneTouches found{none, none, Lanes(kNoLimitM), none, none, none, none, noLane()};
    Lanes3 last = {none, none, none};
    for (std::size_t n = 0; n < question.nodes; ++n) {
        const bool ends = n > 0 && isAsked(n - 1);
        if (!ends && (n + 1 == question.nodes || !isAsked(n)))
            continue;
        const Lanes3 next = seenBy(lens, loaded3(question.nodesWo + n * sim::StrandBlocks::kNodeStride + lane));
        const Lanes3 from = last;
        last = next;
        if (!ends)
            continue;
        const Lanes nearestM = least(from.z, next.z);
        const Lanes stray = strayM * (Lanes(lens.px()) / most(nearestM, Lanes(Lens::kNearestM)));
        const Yes near = counts & (least(from.x, next.x) - stray <= Lanes(brush.box.right)) &
                         (most(from.x, next.x) + stray >= Lanes(brush.box.left)) &
                         (least(from.y, next.y) - stray <= Lanes(brush.box.bottom)) &
                         (most(from.y, next.y) + stray >= Lanes(brush.box.top)) & (nearestM > none);
        if (!any(near))
            continue;
        Lanes fraction;
        Lanes apart;
        nearestTo(brush, {from.x, from.y}, {next.x, next.y}, fraction, apart);
        const Yes touching = near & (apart <= Lanes(brush.radiusPx) + stray);
        const Lanes node(static_cast<float>(n));
        found.lastNode = select(touching, node, found.lastNode);
        const Yes wanted = touching & (apart < found.apart) & (nearestM - strayM <= Lanes(cover.deepestM));
        if (!any(wanted))
            continue;
        const Lanes3 at = from + (next - from) * fraction;
        const Yes seen = wanted & !hiddenByHair(front, at) & !hiddenBySkin(skin, at);
        found.firstNode = select(found.found, found.firstNode, select(seen, node, found.firstNode));
        found.firstFraction = select(found.found, found.firstFraction, select(seen, fraction, found.firstFraction));
        found.found = found.found | seen;
        found.node = select(seen, node, found.node);
        found.fraction = select(seen, fraction, found.fraction);
        found.apart = select(seen, apart, found.apart);
        found.stray = select(seen, stray, found.stray);
    }
    touches.strands |= bitsOf(found.found) << lane;
    stored(found.node, touches.node.data() + lane);
    stored(found.fraction, touches.fraction.data() + lane);
    stored(found.apart, touches.apartPx.data() + lane);
    stored(found.stray, touches.strayPx.data() + lane);
    stored(found.firstNode, touches.firstNode.data() + lane);
    stored(found.firstFraction, touches.firstFraction.data() + lane);
    stored(found.lastNode, touches.lastNode.data() + lane);
}

void Touches(const Lens& lens, const BlockQuestion& question, const PictureBrush& brush, const BrushCover& cover,
             BlockTouches& touches)
{
    touches.strands = 0;
    for (std::size_t lane = 0; lane < kPickLanes; lane += hn::Lanes(Tag()))
        touchFrom(lens, question, brush, cover, lane, touches);
}

} // namespace hairpaint::view::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hairpaint::view {

HWY_EXPORT(Touches);

void findTouches(const Lens& lens, const BlockQuestion& question, const PictureBrush& brush, const BrushCover& cover,
                 BlockTouches& touches)
{
    HWY_DYNAMIC_DISPATCH(Touches)(lens, question, brush, cover, touches);
}

} // namespace hairpaint::view
#endif
