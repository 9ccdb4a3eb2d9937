// Great circles, then points between their neighbours, coarse to fine.
#include "sim/groom/taut_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/groom/taut_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include "sim/groom/skin_distance_inl.h"
#include "sim/groom/unit_vector_inl.h"
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

constexpr std::size_t kLast = kStringPoints - 1;
constexpr std::size_t kCoarse = 3;                    ///< Spans of a string at first; they are halved twice.
constexpr std::array<std::size_t, 3> kPulls{5, 4, 3}; ///< Times that a string is pulled before, between and after.
constexpr float kOtherSide = 0.3F; ///< Cosine of the angle at the middle of the head, between a root and the end, below
                                   ///< which the root is on the other side.
static_assert(kCoarse << 2U == kLast);

using Points = std::array<Lanes3, kStringPoints>;

HWY_INLINE Lanes3 outOfSkin(const TautTask& task, const Lanes3& point)
{
    return pushedOut(*task.distance, point, kStringClearanceM, task.centreHd);
}

void pull(const TautTask& task, Points& p, std::size_t stride, std::size_t times)
{
    const std::size_t inner = kLast / stride - 1;
    for (std::size_t pull = 0; pull < times; ++pull)
        for (std::size_t k = 1; k <= inner; ++k) {
            // To and fro, so that neither end is favoured.
            const std::size_t i = (pull % 2 == 0 ? k : inner + 1 - k) * stride;
            p[i] = outOfSkin(task, (p[i - stride] + p[i + stride]) * 0.5F);
        }
}

/// Lays the coarse points, those in between by a great circle that is led to a side; returns the length.
Lanes layCoarse(const TautTask& task, Points& p, const Lanes3& aside)
{
    constexpr std::size_t kStride = kLast / kCoarse;
    const Lanes3 centre = tripleOf<Lanes>(task.centreHd);
    const Lanes3 outward = tripleOf<Lanes>(task.outwardHd);
    const Lanes3 a = p[0] - centre;
    const Lanes3 b = p[kLast] - centre;
    const Lanes lengthA = lengthOf(a);
    const Lanes lengthB = lengthOf(b);
    for (std::size_t i = kStride; i < kLast; i += kStride) {
        const float t = static_cast<float>(i) / static_cast<float>(kLast);
        const Lanes3 between = unitOr(a, outward) * (1.0F - t) + unitOr(b, outward) * t;
        const Lanes far = lengthA * (1.0F - t) + lengthB * t;
        p[i] = outOfSkin(task, centre + unitOr(between + aside, outward) * far);
    }
    pull(task, p, kStride, kPulls[0]);
    Lanes length(0.0F);
    for (std::size_t i = kStride; i <= kLast; i += kStride)
        length = length + lengthOf(p[i] - p[i - kStride]);
    return length;
}

/// Lanes from `lane` on.
HWY_INLINE void pullFrom(const TautTask& task, std::size_t lane)
{
    float* const points = task.pointsHd + lane;
    const Lanes3 centre = tripleOf<Lanes>(task.centreHd);
    const Lanes3 outward = tripleOf<Lanes>(task.outwardHd);
    Points p;
    for (Lanes3& point : p)
        point = tripleOf<Lanes>(task.endHd);
    p[0] = loaded3(points);
    Lanes shortest = layCoarse(task, p, Lanes3{0.0F, 0.0F, 0.0F});
    const Yes isOpposite = dot(unitOr(p[0] - centre, outward), unitOr(p[kLast] - centre, outward)) < kOtherSide;
    if (any(isOpposite))
        for (const glm::vec3 aside : {glm::vec3(0.0F, 1.0F, 0.0F), glm::vec3(0.0F, 0.0F, -1.0F)}) {
            Points other = p;
            // Nobody ties hair across a face.
            constexpr float kFavoured = 0.8F;
            const Lanes length = layCoarse(task, other, tripleOf<Lanes>(aside)) * kFavoured;
            const Yes isShorter = isOpposite & (length < shortest);
            shortest = select(isShorter, length, shortest);
            for (std::size_t i = 0; i < p.size(); ++i)
                p[i] = select(isShorter, other[i], p[i]);
        }
    std::size_t stride = kLast / kCoarse;
    for (std::size_t level = 1; level < kPulls.size(); ++level) {
        stride /= 2;
        for (std::size_t i = stride; i < kLast; i += 2 * stride)
            p[i] = outOfSkin(task, (p[i - stride] + p[i + stride]) * 0.5F);
        pull(task, p, stride, kPulls[level]);
    }
    for (std::size_t i = 1; i < p.size(); ++i)
        stored3(p[i], points + i * StrandBlocks::kNodeStride);
}

void PullLanesOf(const TautTask& task)
{
    for (std::size_t lane = 0; lane < kLanes; lane += hn::Lanes(Tag()))
        pullFrom(task, lane);
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hairpaint::sim {

HWY_EXPORT(PullLanesOf);

void pullLanes(const TautTask& task)
{
    HWY_DYNAMIC_DISPATCH(PullLanesOf)(task);
}

} // namespace hairpaint::sim
#endif
