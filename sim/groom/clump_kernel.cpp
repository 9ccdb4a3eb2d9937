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

HWY_INLINE Lanes cosineBetween(const Lanes3& a, const Lanes3& b)
{
    const Lanes product = root(dot(a, a) * dot(b, b));
    return dot(a, b) / most(product, 1e-20F);
}

/// How far hairs of these steps from their roots and of these reaches to their tips belong to one lock, 0..1. Tips of
/// hair that hangs are alike on both sides of a parting, but roots leave it to their own: drawn over to the other they
/// would stand over the parting and fall over the face.
HWY_INLINE Lanes alignment(const Lanes3& step, const Lanes3& basisStep, const Lanes3& reach, const Lanes3& basisReach)
{
    const Lanes atRoot = cosineBetween(step, basisStep);
    const Lanes atTip = cosineBetween(reach, basisReach);
    return clamped(atRoot + atRoot + 0.5F, 0.0F, 1.0F) * clamped(atTip + atTip, 0.0F, 1.0F);
}

HWY_INLINE Lanes3 between(const Lanes3& a, const Lanes3& b, Lanes t)
{
    return a + (b - a) * t;
}

/// What a lock does with its hairs' distances from the basis hair, beside drawing them to it.
struct LockShape
{
    bool isPlain = true; ///< Round, straight, closed to the tip.
    float flatness = 0.0F;
    float twistRadPerM = 0.0F;
    float parting = 0.0F;
    Lanes3 normal{0.0F, 0.0F, 0.0F};
    Lanes3 axis{0.0F, 0.0F, 0.0F};

    /// A node at `alongM` of hairs drawn to `beside` by the fraction `drawn` of their distance `own` - `beside`.
    [[nodiscard]] HWY_INLINE Lanes3 drawnTo(const Lanes3& own, const Lanes3& toBasis, Lanes drawn, Lanes alongM) const
    {
        const Lanes3 beside = own + toBasis;
        Lanes3 kept = toBasis * (drawn - 1.0F);
        kept = kept - normal * (dot(kept, normal) * (drawn * flatness));
        const Lanes angle = alongM * drawn * twistRadPerM;
        const Lanes3 across = kept - axis * dot(kept, axis);
        const Lanes sine = sinOf(angle);
        const Lanes cosine = cosOf(angle);
        return beside + (kept - across) + across * cosine + cross(axis, across) * sine;
    }
};

/// How far hairs have left their lock at a fraction s, 0..1.
HWY_INLINE float partedAt(float s)
{
    constexpr float kFrom = 2.0F / 3.0F;
    const float t = s > kFrom ? (s - kFrom) * (1.0F / (1.0F - kFrom)) : 0.0F;
    return t * t;
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
    const Lanes3 basisRoot = loaded3(basis);
    const Lanes clump =
        onlyWhere(clumps, row(task.clump) * alignment(loaded3(nodes + StrandBlocks::kNodeStride) - rootHd,
                                                      loaded3(basis + StrandBlocks::kNodeStride) - basisRoot,
                                                      loaded3(nodes + last * StrandBlocks::kNodeStride) - rootHd,
                                                      basisTip - basisRoot));
    stored(clump, task.clump.data() + lane);
    const Ints laneNumbers = hn::Iota(di, 0);

    LockShape shape{.flatness = task.locks.flatness,
                    .twistRadPerM = task.locks.twistsPerM * 6.2831853F,
                    .parting = task.locks.parting};
    shape.isPlain = shape.flatness == 0.0F && shape.twistRadPerM == 0.0F && shape.parting == 0.0F;
    if (!shape.isPlain) {
        const Lanes3 reach = basisTip - basisRoot;
        shape.axis = reach * (1.0F / root(most(dot(reach, reach), 1e-12F)));
        shape.normal = Lanes3{row(task.leaderNormal[0]), row(task.leaderNormal[1]), row(task.leaderNormal[2])};
    }

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
        Lanes3 drawn = own + toBasis * (clump * (s * (2.0F - s)));
        if (!shape.isPlain)
            drawn = shape.drawnTo(own, toBasis, clump * (s * (2.0F - s) * (1.0F - shape.parting * partedAt(s))),
                                  segment * static_cast<float>(i));
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
