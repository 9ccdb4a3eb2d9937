// Toward the basis hair, node by node, each at its distance from the one before.
#include "sim/groom/clump_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/groom/clump_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include "sim/base/at_length_inl.h"
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

/// How far two hairs go the same way, 0..1.
HWY_INLINE Lanes sameWay(const Lanes3& a, const Lanes3& b)
{
    const Lanes product = root(dot(a, a) * dot(b, b));
    const Lanes cosine = dot(a, b) / most(product, 1e-20F);
    return clamped(cosine + cosine, 0.0F, 1.0F);
}

HWY_INLINE Lanes3 between(const Lanes3& a, const Lanes3& b, Lanes t)
{
    return a + (b - a) * t;
}

/// Lanes from `lane` on.
HWY_INLINE void clumpFrom(ClumpTask& task, std::size_t lane)
{
    const IntTag di;
    const auto last = static_cast<std::size_t>(task.nodes - 1);
    const auto row = [&](const ClumpTask::Row& values) { return loaded(values.data() + lane); };
    float* const nodes = task.nodesHd + lane;
    const float* const basis = task.basisHd + lane;
    const Yes clumps = row(task.clump) > 0.0F;
    if (!any(clumps))
        return;
    const Lanes segment = row(task.segmentM);
    const Lanes perBasisSegment = segment / select(clumps, row(task.basisSegmentM), 1.0F);
    const Lanes basisEnd(static_cast<float>(last));
    const Lanes lastSegment(static_cast<float>(last - 1));
    const Lanes3 rootHd = loaded3(nodes);
    const Lanes3 basisTip = loaded3(basis + last * StrandBlocks::kNodeStride);
    const Lanes clump =
        onlyWhere(clumps, row(task.clump) * sameWay(loaded3(nodes + last * StrandBlocks::kNodeStride) - rootHd,
                                                    basisTip - loaded3(basis)));
    stored(clump, task.clump.data() + lane);
    const Ints laneNumbers = hn::Iota(di, 0);

    Lanes3 parent = rootHd;
    Lanes3 parentBefore = rootHd;
    Lanes3 toBasis{0.0F, 0.0F, 0.0F};
    for (std::size_t i = 1; i <= last; ++i) {
        float* const at = nodes + i * StrandBlocks::kNodeStride;
        const Lanes3 own = loaded3(at);
        const Lanes along = static_cast<float>(i) * perBasisSegment;
        const Yes reaches = along < basisEnd;
        const Ints from = asInts(least(along, lastSegment));
        const Lanes fraction = along - asFloats(from);
        const Ints first =
            hn::Add(hn::Mul(from, hn::Set(di, static_cast<std::int32_t>(StrandBlocks::kNodeStride))), laneNumbers);
        const auto gathered = [&](std::size_t offset) {
            return Lanes3{gatheredFrom(basis + offset, first),
                          gatheredFrom(basis + offset + StrandBlocks::kAxisStride, first),
                          gatheredFrom(basis + offset + 2 * StrandBlocks::kAxisStride, first)};
        };
        const Lanes3 beside = between(gathered(0), gathered(StrandBlocks::kNodeStride), fraction);
        // In the segment in which the basis hair ends, from its end.
        const Yes ends = (!reaches) & (along < basisEnd + perBasisSegment);
        const Lanes back = (basisEnd - along) / select(ends, perBasisSegment, 1.0F) + 1.0F;
        toBasis = select(ends, basisTip - between(parentBefore, own, back), toBasis);
        toBasis = select(reaches, beside - own, toBasis);
        const float s = static_cast<float>(i) / static_cast<float>(last);
        const Lanes3 drawn = own + toBasis * (clump * (s * (2.0F - s)));
        // Should a node fall on its parent, it goes where it was headed.
        const Lanes3 headed = own - parentBefore;
        parentBefore = own;
        parent = select(clumps & (segment > 0.0F), atLength(parent, drawn, segment, headed), own);
        stored3(parent, at);
    }
}

void ClumpLanesOf(ClumpTask& task)
{
    for (std::size_t lane = 0; lane < kLanes; lane += hn::Lanes(Tag()))
        clumpFrom(task, lane);
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hairpaint::sim {

HWY_EXPORT(ClumpLanesOf);

void clumpLanes(ClumpTask& task)
{
    HWY_DYNAMIC_DISPATCH(ClumpLanesOf)(task);
}

} // namespace hairpaint::sim
#endif
