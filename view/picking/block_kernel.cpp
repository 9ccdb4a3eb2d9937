// Projection, boxes and distances by vectors of the machine.
#include "view/picking/block_kernel.h"

#include "view/picking/hair_boxes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "view/picking/block_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include "view/picking/picking_lanes_inl.h"
#include <algorithm>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hairpaint::view::HWY_NAMESPACE {

HWY_INLINE void lookFrom(const Lens& lens, const BlockQuestion& question, std::size_t lane, BlockAnswer& answer)
{
    const Lanes strayM = loaded(question.straysM + lane);
    const auto spanOf = [](std::size_t segment) { return segment / HairBoxes::kSpan; };
    const auto isAsked = [&](std::size_t segment) { return (question.spans >> spanOf(segment) & 1U) != 0; };
    Lanes3 last = {0.0F, 0.0F, 0.0F};
    for (std::size_t n = 0; n < question.nodes; ++n) {
        const bool ends = n > 0 && isAsked(n - 1);
        if (!ends && (n + 1 == question.nodes || !isAsked(n)))
            continue;
        const Lanes3 next = seenBy(lens, loaded3(question.nodesWo + n * sim::StrandBlocks::kNodeStride + lane));
        stored3(next, answer.seen[n].data() + lane);
        if (ends) {
            const Lanes nearestM = least(last.z, next.z);
            const Lanes stray = strayM * (Lanes(lens.px()) / most(nearestM, Lanes(Lens::kNearestM)));
            const Yes near = (least(last.x, next.x) - stray <= Lanes(question.box.right)) &
                             (most(last.x, next.x) + stray >= Lanes(question.box.left)) &
                             (least(last.y, next.y) - stray <= Lanes(question.box.bottom)) &
                             (most(last.y, next.y) + stray >= Lanes(question.box.top)) & (nearestM > Lanes(0.0F)) &
                             (nearestM - strayM <= Lanes(question.deepestM));
            const std::uint32_t lanes = bitsOf(near) << lane & question.lanes;
            answer.near[n] |= lanes;
            answer.anyNear |= lanes;
            if (lanes != 0)
                stored(stray, answer.strayPx[n].data() + lane);
        }
        last = next;
    }
}

void LookFor(const Lens& lens, const BlockQuestion& question, BlockAnswer& answer)
{
    for (std::size_t lane = 0; lane < kPickLanes; lane += hn::Lanes(Tag()))
        lookFrom(lens, question, lane, answer);
}

HWY_INLINE float leastOf(Lanes a)
{
    return hn::GetLane(hn::MinOfLanes(Tag(), a.v));
}
HWY_INLINE float mostOf(Lanes a)
{
    return hn::GetLane(hn::MaxOfLanes(Tag(), a.v));
}

/// A box a lane.
struct LaneBoxes
{
    Lanes left, top, right, bottom, nearestM;
    HWY_INLINE void add(const Lanes3& seen, Yes there)
    {
        left = select(there, least(left, seen.x), left);
        top = select(there, least(top, seen.y), top);
        right = select(there, most(right, seen.x), right);
        bottom = select(there, most(bottom, seen.y), bottom);
        nearestM = select(there, least(nearestM, seen.z), nearestM);
    }
};
HWY_INLINE LaneBoxes emptyBoxes()
{
    const Lanes far(kNoLimitM);
    const Lanes farLeft(-kNoLimitM);
    return {.left = far, .top = far, .right = farLeft, .bottom = farLeft, .nearestM = far};
}

void BoxesOf(const Lens& lens, const BlockQuestion& question, PictureBox* boxes, float* nearestM)
{
    PickRow counted{};
    for (std::size_t lane = 0; lane < kPickLanes; ++lane)
        counted[lane] = (question.lanes >> lane & 1U) != 0 ? 1.0F : 0.0F;
    const std::size_t spans = (question.nodes - 1 + HairBoxes::kSpan - 1) / HairBoxes::kSpan;
    std::fill_n(boxes, spans, PictureBox{});
    std::fill_n(nearestM, spans, kNoLimitM);
    for (std::size_t lane = 0; lane < kPickLanes; lane += hn::Lanes(Tag())) {
        const Yes counts = loaded(counted.data() + lane) > Lanes(0.0F);
        if (!any(counts))
            continue;
        LaneBoxes box = emptyBoxes();
        for (std::size_t n = 0; n < question.nodes; ++n) {
            const Lanes3 seen = seenBy(lens, loaded3(question.nodesWo + n * sim::StrandBlocks::kNodeStride + lane));
            const Yes there = counts & (seen.z > Lanes(0.0F));
            box.add(seen, there);
            if (n == 0 || (n % HairBoxes::kSpan != 0 && n + 1 < question.nodes))
                continue;
            // A node between two spans ends the one and begins the other.
            const std::size_t span = (n - 1) / HairBoxes::kSpan;
            boxes[span].add({.left = leastOf(box.left),
                             .top = leastOf(box.top),
                             .right = mostOf(box.right),
                             .bottom = mostOf(box.bottom)});
            nearestM[span] = std::min(nearestM[span], leastOf(box.nearestM));
            box = emptyBoxes();
            box.add(seen, there);
        }
    }
}

void RowsSeen(const Lens& lens, const float* rowsWo, std::size_t rows, float* seen)
{
    constexpr std::size_t kRow = 3 * kPickLanes;
    for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t lane = 0; lane < kPickLanes; lane += hn::Lanes(Tag()))
            stored3(seenBy(lens, loaded3(rowsWo + row * kRow + lane)), seen + row * kRow + lane);
}

void CurvesNear(const float* seen, std::size_t points, const PictureBox& box, std::uint32_t* near)
{
    constexpr std::size_t kRow = 3 * kPickLanes;
    std::fill_n(near, points, 0U);
    for (std::size_t lane = 0; lane < kPickLanes; lane += hn::Lanes(Tag())) {
        Lanes3 last = loaded3(seen + lane);
        for (std::size_t i = 1; i < points; ++i) {
            const Lanes3 next = loaded3(seen + i * kRow + lane);
            const Yes meets = (least(last.x, next.x) <= Lanes(box.right)) & (most(last.x, next.x) >= Lanes(box.left)) &
                              (least(last.y, next.y) <= Lanes(box.bottom)) & (most(last.y, next.y) >= Lanes(box.top)) &
                              (least(last.z, next.z) > Lanes(0.0F));
            near[i] |= bitsOf(meets) << lane;
            last = next;
        }
    }
}

void LengthsAlong(const float* pointsWo, std::size_t points, float* alongM)
{
    constexpr std::size_t kRow = 3 * kPickLanes;
    for (std::size_t lane = 0; lane < kPickLanes; lane += hn::Lanes(Tag())) {
        Lanes3 last = loaded3(pointsWo + lane);
        Lanes along = 0.0F;
        stored(along, alongM + lane);
        for (std::size_t i = 1; i < points; ++i) {
            const Lanes3 next = loaded3(pointsWo + i * kRow + lane);
            const Lanes3 step = next - last;
            along = along + root(dot(step, step));
            stored(along, alongM + i * kPickLanes + lane);
            last = next;
        }
    }
}

} // namespace hairpaint::view::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hairpaint::view {

HWY_EXPORT(LookFor);
HWY_EXPORT(BoxesOf);
HWY_EXPORT(RowsSeen);
HWY_EXPORT(CurvesNear);
HWY_EXPORT(LengthsAlong);

void findNear(const Lens& lens, const BlockQuestion& question, BlockAnswer& answer)
{
    std::fill_n(answer.near.begin(), question.nodes, 0U);
    answer.anyNear = 0;
    HWY_DYNAMIC_DISPATCH(LookFor)(lens, question, answer);
}

void findBoxes(const Lens& lens, const BlockQuestion& question, PictureBox* boxes, float* nearestM)
{
    HWY_DYNAMIC_DISPATCH(BoxesOf)(lens, question, boxes, nearestM);
}

void seeRows(const Lens& lens, const float* rowsWo, std::size_t rows, float* seen)
{
    HWY_DYNAMIC_DISPATCH(RowsSeen)(lens, rowsWo, rows, seen);
}

void findCurvesNear(const float* seen, std::size_t points, const PictureBox& box, std::uint32_t* near)
{
    HWY_DYNAMIC_DISPATCH(CurvesNear)(seen, points, box, near);
}

void measureCurves(const float* pointsWo, std::size_t points, float* alongM)
{
    HWY_DYNAMIC_DISPATCH(LengthsAlong)(pointsWo, points, alongM);
}

} // namespace hairpaint::view
#endif
