// Dependent hairs: interpolated displacement, restored lengths, pushed out of the head.
#include "sim/solver/dependents_kernel.h"

#include "sim/solver/agreement.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/solver/dependents_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include "sim/solver/strand_kernel_inl.h"
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

constexpr float kAnywhereM = 1.0F;
constexpr float kCarriedM = 0.08F; ///< Shorter hair holds its own shape,
constexpr float kHangingM = 0.20F; ///< and longer hair does not.

/// Weighted mean of one slot's three basis hairs into mean: [nodes][2][kLanes][4], at its lane.
HWY_INLINE void gather(const DependentsTask& task, std::size_t slot, float* HWY_RESTRICT mean)
{
    const hn::CappedTag<float, 4> d4;
    const auto nodes = static_cast<std::size_t>(task.nodes);
    const std::array<std::uint32_t, 3>& basis = task.neighbours[slot];
    std::array<float, 3> weight = task.weights[slot];
    const float* const first = task.displacements + basis[0] * nodes * kBasisFloats;
    const float* const second = task.displacements + basis[1] * nodes * kBasisFloats;
    const float* const third = task.displacements + basis[2] * nodes * kBasisFloats;
    const std::size_t tip = (nodes - 1) * kBasisFloats;
    const std::array<const float*, 3> all{first, second, third};
    if (weight[1] != 0.0F || weight[2] != 0.0F) {
        std::size_t foremost = weight[1] > weight[0] ? 1 : 0;
        foremost = weight[2] > weight[foremost] ? 2 : foremost;
        float sum = 0.0F;
        for (std::size_t k = 0; k < all.size(); ++k) {
            if (k != foremost)
                weight[k] *= agreementOfTips(all[foremost] + tip, all[k] + tip);
            sum += weight[k];
        }
        for (float& w : weight)
            w *= 1.0F / sum;
    } else {
        weight[0] = 1.0F;
    }
    const auto w0 = hn::Set(d4, weight[0]);
    const auto w1 = hn::Set(d4, weight[1]);
    const auto w2 = hn::Set(d4, weight[2]);
    const bool alone = weight[1] == 0.0F && weight[2] == 0.0F;
    const std::size_t step = hn::Lanes(d4); // 4, or 1 where there is no SIMD
    for (std::size_t i = 0; i < nodes * 2; ++i) {
        for (std::size_t axis = 0; axis < 4; axis += step) {
            const std::size_t at = i * 4 + axis;
            auto sum = hn::Mul(w0, hn::Load(d4, first + at));
            if (!alone)
                sum = hn::Add(hn::Add(sum, hn::Mul(w1, hn::Load(d4, second + at))),
                              hn::Mul(w2, hn::Load(d4, third + at)));
            hn::Store(sum, d4, mean + i * kLanes * 4 + axis);
        }
    }
}

/// Keeps a node outside every ellipsoid, and it and its segment outside the skin; true where any lane was inside one.
template<class D>
HWY_INLINE bool collide(D d, const DependentsTask& task, const float* HWY_RESTRICT lanes, bool first,
                        const Vec3<hn::Vec<D>>& parent, Vec3<hn::Vec<D>>& p, Contact<D>& contact)
{
    bool any = false;
    const auto furthest = hn::Set(d, kAnywhereM);
    for (int c = 0; c < task.colliders->count; ++c)
        any |= pushOut(d, task.colliders->items[static_cast<std::size_t>(c)], task.neck,
                       hn::LoadU(d, lanes + (kDependentScale + c) * kLanes), furthest, p, contact);
    if (task.colliders->skin.pairs != nullptr)
        any |=
            pushSegmentOutOfSkin(d, task.colliders->skin, task.neck, hn::LoadU(d, lanes + kDependentClearance * kLanes),
                                 furthest, first, parent, p, contact);
    return any;
}

/// Lanes lane..lane + Lanes(d) of one block, from their mean displacements to their places in the world.
template<class D>
HWY_INLINE void placeStrands(D d, const DependentsTask& task, const float* HWY_RESTRICT mean,
                             const float* HWY_RESTRICT rest, const float* HWY_RESTRICT lanes, float* HWY_RESTRICT out)
{
    using V = hn::Vec<D>;
    const V segment = hn::LoadU(d, lanes);
    const hn::Mask<D> drawn = hn::Gt(segment, hn::Zero(d));
    const V length = hn::Mul(segment, hn::Set(d, static_cast<float>(task.nodes - 1)));
    const V zero = hn::Zero(d);
    const Vec3<V> nothing{zero, zero, zero};
    const Vec3<V> root = load3(d, rest);
    const Vec3<V> clump = load3(d, lanes + kDependentClumpX * kLanes);
    const V one = hn::Set(d, 1.0F);
    // None of hair of 8 cm, all of 20 cm and more, once the tips around have sunk by a twentieth of it: a rest shape
    // that nothing pulls at is exact. By the squared length.
    const V longness = hn::Mul(hn::Sub(length, hn::Set(d, kCarriedM)), hn::Set(d, 1.0F / (kHangingM - kCarriedM)));
    Vec3<V> sunk;
    V beside;
    hn::LoadInterleaved4(d, mean + static_cast<std::size_t>(2 * (task.nodes - 1)) * kLanes * 4, sunk.x, sunk.y, sunk.z,
                         beside);
    const V hangs = hn::Min(one, hn::Mul(dot(sunk, sunk), hn::Set(d, 400.0F)));
    const V straying = hn::Div(hn::Mul(hangs, hn::Min(hn::Max(longness, zero), one)),
                               hn::Max(hn::Mul(length, length), hn::Set(d, 1e-8F)));
    Vec3<V> parent = root;
    Vec3<V> parentRest = parent;
    store3(d, choose(drawn, task.world.identity ? parent : moved(d, task.world, parent), nothing), out);
    for (int i = 1; i < task.nodes; ++i) {
        const auto node = static_cast<std::size_t>(i);
        const std::size_t offset = node * StrandBlocks::kNodeStride;
        Vec3<V> displacement;
        Vec3<V> shape;
        V unused;
        V stretch;
        hn::LoadInterleaved4(d, mean + (2 * node) * kLanes * 4, displacement.x, displacement.y, displacement.z, unused);
        hn::LoadInterleaved4(d, mean + (2 * node + 1) * kLanes * 4, shape.x, shape.y, shape.z, stretch);
        const V stretched = hn::Add(segment, hn::Mul(segment, stretch));
        const Vec3<V> styled = load3(d, rest + offset);
        // How its basis hairs lie, at its own root or, clumped, at the nearest one's.
        const float s = static_cast<float>(i) / static_cast<float>(task.nodes - 1);
        const Vec3<V> common = add(addScaled(root, shape, length), scale(clump, hn::Set(d, s * (2.0F - s))));
        const Vec3<V> own = sub(styled, common);
        // All of its own is left where they have not moved, nothing where by half of the way from the root; and of long
        // hair, which does not carry itself, all that leads away from theirs by a sixth of the way, nothing by a third.
        const V moved2 = hn::Mul(dot(displacement, displacement), hn::Set(d, 4.0F / (s * s)));
        const V strays2 = hn::Mul(hn::Mul(dot(own, own), straying), hn::Set(d, 9.0F / (s * s)));
        const V strays = hn::Max(zero, hn::Mul(hn::Sub(strays2, hn::Set(d, 0.25F)), hn::Set(d, 4.0F / 3.0F)));
        const Vec3<V> laid = sub(styled, scale(own, hn::Min(one, hn::Add(moved2, strays))));
        Vec3<V> p = atLength(d, parent, addScaled(laid, displacement, length), stretched, sub(styled, parentRest));
        // Again out of the skin, since restoring the length may lead back in.
        for (int pass = 0; pass < (task.colliders->skin.pairs != nullptr ? 2 : 1); ++pass) {
            Contact<D> contact = noContact(d);
            if (!collide(d, task, lanes, i == 1, parent, p, contact))
                break;
            p = choose(contact.touched, atLength(d, parent, p, stretched, sub(styled, parentRest)), p);
        }
        store3(d, choose(drawn, task.world.identity ? p : moved(d, task.world, p), nothing), out + offset);
        parent = p;
        parentRest = styled;
    }
}

void PlaceDependents(const DependentsTask& task, std::size_t begin, std::size_t end)
{
    const hn::CappedTag<float, kLanes> d;
    const auto nodes = static_cast<std::size_t>(task.nodes);
    const std::size_t laneStride = dependentRows(*task.colliders) * kLanes;
    HWY_ALIGN float mean[std::size_t{kMostNodes} * 2 * kLanes * 4];
    for (std::size_t i = 0; i < nodes * 2 * kLanes * 4; ++i)
        mean[i] = 0.0F;
    for (std::size_t block = begin; block < end; ++block) {
        if (task.detail < 1.0F && !(task.leastDetail[block] < task.detail))
            continue;
        const float* const lanes = task.lanes + block * laneStride;
        const std::size_t first = StrandBlocks(task.nodes).floatsFor(block);
        bool any = false;
        for (std::size_t lane = 0; lane < kLanes; ++lane)
            any |= lanes[lane] > 0.0F;
        if (!any) {
            for (std::size_t i = 0; i < nodes * StrandBlocks::kNodeStride; ++i)
                task.out[first + i] = 0.0F;
            continue;
        }
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            if (lanes[lane] > 0.0F)
                gather(task, block * kLanes + lane, mean + lane * 4);
        }
        for (std::size_t lane = 0; lane < kLanes; lane += hn::Lanes(d))
            placeStrands(d, task, mean + lane * 4, task.rest + first + lane, lanes + lane, task.out + first + lane);
    }
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hairpaint::sim {

HWY_EXPORT(PlaceDependents);

void placeDependents(const DependentsTask& task, std::size_t begin, std::size_t end)
{
    HWY_DYNAMIC_DISPATCH(PlaceDependents)(task, begin, end);
}

} // namespace hairpaint::sim
#endif
