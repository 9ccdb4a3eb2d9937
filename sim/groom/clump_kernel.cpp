// Toward the basis hair, node by node, each at its distance from the one before.
#include "sim/groom/clump_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/groom/clump_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include "sim/base/vec3_inl.h"
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

/// How far two hairs go the same way, 0..1.
template<class D>
HWY_INLINE hn::Vec<D> sameWay(D d, const Vec3<hn::Vec<D>>& a, const Vec3<hn::Vec<D>>& b)
{
    const auto product = hn::Sqrt(hn::Mul(dot(a, a), dot(b, b)));
    const auto cosine = hn::Div(dot(a, b), hn::Max(product, hn::Set(d, 1e-20F)));
    return hn::Min(hn::Max(hn::Add(cosine, cosine), hn::Zero(d)), hn::Set(d, 1.0F));
}

template<class V>
HWY_INLINE Vec3<V> between(const Vec3<V>& a, const Vec3<V>& b, V t)
{
    return addScaled(a, sub(b, a), t);
}

/// Lanes lane..lane + Lanes(d).
template<class D>
HWY_INLINE void clumpFrom(D d, ClumpTask& task, std::size_t lane)
{
    using V = hn::Vec<D>;
    const hn::Rebind<std::int32_t, D> di;
    const auto last = static_cast<std::size_t>(task.nodes - 1);
    const auto row = [&](const ClumpTask::Row& values) { return hn::LoadU(d, values.data() + lane); };
    float* const nodes = task.nodesHd + lane;
    const float* const basis = task.basisHd + lane;
    const V zero = hn::Zero(d);
    const V one = hn::Set(d, 1.0F);
    const hn::Mask<D> clumps = hn::Gt(row(task.clump), zero);
    if (hn::AllFalse(d, clumps))
        return;
    const V segment = row(task.segmentM);
    const V perBasisSegment = hn::Div(segment, hn::IfThenElse(clumps, row(task.basisSegmentM), one));
    const V basisEnd = hn::Set(d, static_cast<float>(last));
    const V lastSegment = hn::Set(d, static_cast<float>(last - 1));
    const Vec3<V> root = load3(d, nodes);
    const Vec3<V> basisTip = load3(d, basis + last * StrandBlocks::kNodeStride);
    const V clump = hn::IfThenElseZero(
        clumps, hn::Mul(row(task.clump), sameWay(d, sub(load3(d, nodes + last * StrandBlocks::kNodeStride), root),
                                                 sub(basisTip, load3(d, basis)))));
    hn::StoreU(clump, d, task.clump.data() + lane);
    const auto laneNumbers = hn::Iota(di, 0);

    Vec3<V> parent = root;
    Vec3<V> parentBefore = root;
    Vec3<V> toBasis{zero, zero, zero};
    for (std::size_t i = 1; i <= last; ++i) {
        float* const at = nodes + i * StrandBlocks::kNodeStride;
        const Vec3<V> own = load3(d, at);
        const V along = hn::Mul(hn::Set(d, static_cast<float>(i)), perBasisSegment);
        const auto reaches = hn::Lt(along, basisEnd);
        const auto from = hn::ConvertTo(di, hn::Min(along, lastSegment));
        const V fraction = hn::Sub(along, hn::ConvertTo(d, from));
        const auto first =
            hn::Add(hn::Mul(from, hn::Set(di, static_cast<std::int32_t>(StrandBlocks::kNodeStride))), laneNumbers);
        const auto gathered = [&](std::size_t offset) {
            return Vec3<V>{hn::GatherIndex(d, basis + offset, first),
                           hn::GatherIndex(d, basis + offset + StrandBlocks::kAxisStride, first),
                           hn::GatherIndex(d, basis + offset + 2 * StrandBlocks::kAxisStride, first)};
        };
        const Vec3<V> beside = between(gathered(0), gathered(StrandBlocks::kNodeStride), fraction);
        // In the segment in which the basis hair ends, from its end.
        const auto ends = hn::AndNot(reaches, hn::Lt(along, hn::Add(basisEnd, perBasisSegment)));
        const V back = hn::Add(hn::Div(hn::Sub(basisEnd, along), hn::IfThenElse(ends, perBasisSegment, one)), one);
        toBasis = choose(ends, sub(basisTip, between(parentBefore, own, back)), toBasis);
        toBasis = choose(reaches, sub(beside, own), toBasis);
        const float s = static_cast<float>(i) / static_cast<float>(last);
        const V drawing = hn::Mul(clump, hn::Set(d, s * (2.0F - s)));
        const Vec3<V> drawn = addScaled(own, toBasis, drawing);
        // Should a node fall on its parent, it goes where it was headed.
        const Vec3<V> headed = sub(own, parentBefore);
        parentBefore = own;
        parent = choose(hn::And(clumps, hn::Gt(segment, zero)), atLength(d, parent, drawn, segment, headed), own);
        store3(d, parent, at);
    }
}

void ClumpLanesOf(ClumpTask& task)
{
    const hn::CappedTag<float, kLanes> d;
    for (std::size_t lane = 0; lane < kLanes; lane += hn::Lanes(d))
        clumpFrom(d, task, lane);
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
