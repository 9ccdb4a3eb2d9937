// Dependent hairs: interpolated displacement, restored lengths, pushed out of the head.
#include "sim/solver/dependents_kernel.h"

#include "sim/solver/agreement.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/solver/dependents_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include "sim/base/at_length_inl.h"
#include "sim/solver/constraints/neck_contact_inl.h"
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

constexpr float kAnywhereM = 1.0F;
constexpr float kCarriedM = 0.08F; ///< Shorter hair holds its own shape,
constexpr float kHangingM = 0.20F; ///< and longer hair does not.

/// Weighted mean of one slot's three basis hairs into mean: [nodes][2][kLanes][4], at its lane.
HWY_INLINE void gather(const DependentsTask& task, std::size_t slot, float* HWY_RESTRICT mean)
{
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
    const Quad w0 = quadOf(weight[0]);
    const Quad w1 = quadOf(weight[1]);
    const Quad w2 = quadOf(weight[2]);
    const bool alone = weight[1] == 0.0F && weight[2] == 0.0F;
    for (std::size_t i = 0; i < nodes * 2; ++i) {
        const std::size_t at = i * 4;
        Quad sum = w0 * quadOf(first + at);
        if (!alone)
            sum = sum + w1 * quadOf(second + at) + w2 * quadOf(third + at);
        stored(sum, mean + i * kLanes * 4);
    }
}

/// Keeps a node outside every solid, and it and its segment outside the skin; true where any lane was inside one.
HWY_INLINE bool collide(const DependentsTask& task, const float* HWY_RESTRICT lanes, bool first, const Lanes3& parent,
                        Lanes3& p, Contact& contact)
{
    bool touches = false;
    for (int c = 0; c < task.colliders->count; ++c)
        touches |= pushOut(task.colliders->items[static_cast<std::size_t>(c)], task.neck,
                           loaded(lanes + (kDependentScale + c) * kLanes), kAnywhereM, p, contact);
    if (task.colliders->skin.pairs != nullptr)
        touches |= pushSegmentOutOfSkin(task.colliders->skin, task.neck, loaded(lanes + kDependentClearance * kLanes),
                                        kAnywhereM, first, parent, p, contact);
    return touches;
}

/// Four numbers of a node's mean, of which three are a vector.
struct MeanOfNode
{
    Lanes3 vector;
    Lanes beside;
};

HWY_INLINE MeanOfNode meanAt(const float* HWY_RESTRICT mean, std::size_t row)
{
    MeanOfNode node;
    hn::LoadInterleaved4(Tag(), mean + row * kLanes * 4, node.vector.x.v, node.vector.y.v, node.vector.z.v,
                         node.beside.v);
    return node;
}

/// How much of what is its own a long hair gives up where those around hang: none of hair of 8 cm, all of 20 cm and
/// more, once the tips around have sunk by a twentieth of it: a rest shape that nothing pulls at is exact. By the
/// squared length.
HWY_INLINE Lanes strayingOf(Lanes length, const Lanes3& sunk)
{
    const Lanes longness = (length - kCarriedM) * (1.0F / (kHangingM - kCarriedM));
    const Lanes hangs = least(Lanes(1.0F), dot(sunk, sunk) * 400.0F);
    return hangs * clamped(longness, 0.0F, 1.0F) / most(length * length, 1e-8F);
}

/// Where a node lies that is styled at `styled` while its basis hairs lie as `common`. All of its own is left where
/// they have not moved (by `displacement`), nothing where by half of the distance from the root; and of long hair,
/// which does not carry itself, all that leads away from theirs by a sixth of that distance, nothing by a third.
HWY_INLINE Lanes3 laidAmong(const Lanes3& styled, const Lanes3& common, const Lanes3& displacement, Lanes straying,
                            float s)
{
    const Lanes3 own = styled - common;
    const Lanes moved2 = dot(displacement, displacement) * (4.0F / (s * s));
    const Lanes strays2 = dot(own, own) * straying * (9.0F / (s * s));
    const Lanes strays = most(Lanes(0.0F), (strays2 - 0.25F) * (4.0F / 3.0F));
    return styled - own * least(Lanes(1.0F), moved2 + strays);
}

/// The lanes from one on of a block, from their mean displacements to the world.
HWY_INLINE void positionStrands(const DependentsTask& task, const float* HWY_RESTRICT mean,
                                const float* HWY_RESTRICT rest, const float* HWY_RESTRICT lanes,
                                float* HWY_RESTRICT out)
{
    const Lanes segment = loaded(lanes);
    const Yes drawn = segment > 0.0F;
    const Lanes length = segment * static_cast<float>(task.nodes - 1);
    const Lanes3 nothing{0.0F, 0.0F, 0.0F};
    const Lanes3 root = loaded3(rest);
    const Lanes3 clump = loaded3(lanes + kDependentClumpX * kLanes);
    const Lanes straying = strayingOf(length, meanAt(mean, 2 * static_cast<std::size_t>(task.nodes - 1)).vector);
    const auto write = [&](const Lanes3& p, std::size_t offset) {
        stored3(select(drawn, task.world.identity ? p : moved(task.world, p), nothing), out + offset);
    };
    Lanes3 parent = root;
    Lanes3 parentRest = parent;
    write(parent, 0);
    for (int i = 1; i < task.nodes; ++i) {
        const auto node = static_cast<std::size_t>(i);
        const std::size_t offset = node * StrandBlocks::kNodeStride;
        const Lanes3 displacement = meanAt(mean, 2 * node).vector;
        const auto [shape, stretch] = meanAt(mean, 2 * node + 1);
        const Lanes stretched = segment + segment * stretch;
        const Lanes3 styled = loaded3(rest + offset);
        // How its basis hairs lie, at its own root or, clumped, at the nearest one's.
        const float s = static_cast<float>(i) / static_cast<float>(task.nodes - 1);
        const Lanes3 common = root + shape * length + clump * (s * (2.0F - s));
        const Lanes3 laid = laidAmong(styled, common, displacement, straying, s);
        Lanes3 p = atLength(parent, laid + displacement * length, stretched, styled - parentRest);
        // Again out of the skin, since restoring the length may lead back in.
        for (int pass = 0; pass < (task.colliders->skin.pairs != nullptr ? 2 : 1); ++pass) {
            Contact contact = noContact();
            if (!collide(task, lanes, i == 1 && !task.beginsInAir, parent, p, contact))
                break;
            p = select(contact.touched, atLength(parent, p, stretched, styled - parentRest), p);
        }
        write(p, offset);
        parent = p;
        parentRest = styled;
    }
}

void PositionDependents(const DependentsTask& task, std::size_t begin, std::size_t end)
{
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
        for (std::size_t lane = 0; lane < kLanes; lane += hn::Lanes(Tag()))
            positionStrands(task, mean + lane * 4, task.rest + first + lane, lanes + lane, task.out + first + lane);
    }
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hairpaint::sim {

HWY_EXPORT(PositionDependents);

void positionDependents(const DependentsTask& task, std::size_t begin, std::size_t end)
{
    HWY_DYNAMIC_DISPATCH(PositionDependents)(task, begin, end);
}

} // namespace hairpaint::sim
#endif
