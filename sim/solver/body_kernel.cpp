// The grid of hair: splatting nodes, reading it at nodes.
#include "sim/solver/body_kernel.h"

#include "sim/solver/solver_layout.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/solver/body_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include "sim/solver/cell_pair_inl.h"
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

/// Pairs of a cell's corners that are beside each other along x; ordered with y fastest, then z.
constexpr std::size_t kPairs = 4;

/// The cells that nodes are in, one a lane, and where in them.
struct CellOfNode
{
    Ints index;
    Lanes3 t; ///< 0..1
};

HWY_INLINE CellOfNode cellOf(const BodyGrid& grid, const Lanes3& p)
{
    const IntTag di;
    Lanes3 c = (p - everyLane(grid.origin)) * grid.inverseCell;
    // What is not a number is in the first cell.
    c = {least(most(c.x, 0.0F), grid.last[0]), least(most(c.y, 0.0F), grid.last[1]),
         least(most(c.z, 0.0F), grid.last[2])};
    const Ints x = asInts(c.x);
    const Ints y = asInts(c.y);
    const Ints z = asInts(c.z);
    const Ints index = hn::Add(x, hn::Add(hn::Mul(y, hn::Set(di, grid.row)), hn::Mul(z, hn::Set(di, grid.slice))));
    return {index, c - Lanes3{asFloats(x), asFloats(y), asFloats(z)}};
}

HWY_INLINE std::array<std::size_t, kPairs> pairOffsets(const BodyGrid& grid)
{
    const auto row = static_cast<std::size_t>(grid.row);
    const auto slice = static_cast<std::size_t>(grid.slice);
    return {0, 4 * row, 4 * slice, 4 * (slice + row)};
}

struct MovingNode
{
    Lanes3 position; ///< Where the node will be in the middle of the steps that a grid is used for.
    Lanes3 velocity; ///< m a step.
};

HWY_INLINE MovingNode nodeAt(const BodyNodes& nodes, std::size_t at)
{
    const Lanes3 now = loaded3(nodes.positions + at);
    const Lanes3 v = now - loaded3(nodes.previous + at);
    const Lanes3 velocity{clamped(v.x, -kBodyFastestM, kBodyFastestM), clamped(v.y, -kBodyFastestM, kBodyFastestM),
                          clamped(v.z, -kBodyFastestM, kBodyFastestM)};
    return {now + velocity * (0.5F * static_cast<float>(kStepsAGrid)), velocity};
}

BodyBounds BoundsOfBody(const BodyNodes& nodes, std::size_t begin, std::size_t end)
{
    constexpr float kFar = 1e6F;
    Lanes3 least3{kFar, kFar, kFar};
    Lanes3 most3{-kFar, -kFar, -kFar};
    const auto count = static_cast<std::size_t>(nodes.nodes);
    for (std::size_t block = begin; block < end; ++block)
        for (std::size_t lane = 0; lane < kLanes; lane += hn::Lanes(Tag())) {
            const Yes counts = loaded(nodes.hair + block * kLanes + lane) > 0.0F;
            if (!any(counts))
                continue;
            for (std::size_t node = kFirstBodyNode; node < count; ++node) {
                const Lanes3 p = nodeAt(nodes, (block * count + node) * StrandBlocks::kNodeStride + lane).position;
                least3 = select(counts, {least(p.x, least3.x), least(p.y, least3.y), least(p.z, least3.z)}, least3);
                most3 = select(counts, {most(p.x, most3.x), most(p.y, most3.y), most(p.z, most3.z)}, most3);
            }
        }
    BodyBounds bounds;
    const std::array<Lanes, 3> low{least3.x, least3.y, least3.z};
    const std::array<Lanes, 3> high{most3.x, most3.y, most3.z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        HWY_ALIGN float values[2 * kLanes];
        stored(low[axis], values);
        stored(high[axis], values + kLanes);
        bounds.least[axis] = *std::min_element(values, values + hn::Lanes(Tag()));
        bounds.greatest[axis] = *std::max_element(values + kLanes, values + kLanes + hn::Lanes(Tag()));
    }
    return bounds;
}

constexpr std::size_t kNodesAtOnce = 8; ///< So many of a strand are made ready before the grid is written or read.

/// What nodes of kLanes strands add to the grid. A strand's nodes are apart: added one after the other, none waits for
/// what the one before has just written to a cell beside its own, as strands side by side would. Sums are the same.
struct SplatNodes
{
    HWY_ALIGN std::int32_t index[kNodesAtOnce * kLanes];     ///< [node][lane]: the cell;
    HWY_ALIGN float value[kNodesAtOnce * kLanes * 4];        ///< [node][lane][4]: its values,
    HWY_ALIGN float x[kNodesAtOnce * kLanes];                ///< the fraction that the second cell of a pair gets,
    HWY_ALIGN float weights[kNodesAtOnce * kPairs * kLanes]; ///< [node][pair][lane]: and that of each pair.
};

HWY_INLINE void prepareSplat(const BodyGrid& grid, const MovingNode& moving, Lanes hair, std::size_t slot,
                             SplatNodes& out)
{
    const CellOfNode cell = cellOf(grid, moving.position);
    hn::Store(cell.index, IntTag(), out.index + slot * kLanes);
    const Lanes3 momentum = moving.velocity * (hair * (1.0F / kBodyFastestM));
    hn::StoreInterleaved4(hair.v, momentum.x.v, momentum.y.v, momentum.z.v, Tag(), out.value + slot * kLanes * 4);
    stored(cell.t.x, out.x + slot * kLanes);
    const Lanes beforeY = 1.0F - cell.t.y;
    const Lanes beforeZ = 1.0F - cell.t.z;
    float* const weights = out.weights + slot * kPairs * kLanes;
    stored(beforeY * beforeZ, weights);
    stored(cell.t.y * beforeZ, weights + kLanes);
    stored(beforeY * cell.t.z, weights + 2 * kLanes);
    stored(cell.t.y * cell.t.z, weights + 3 * kLanes);
}

HWY_INLINE void addNode(const BodyGrid& grid, const std::array<std::size_t, kPairs>& offsets, const SplatNodes& nodes,
                        std::size_t slot, std::size_t lane)
{
    const std::size_t at = slot * kLanes + lane;
    const Quad whole = quadOf(nodes.value + 4 * at);
    const CellPair alongX = pairOf(whole * quadOf(1.0F - nodes.x[at]), whole * quadOf(nodes.x[at]));
    std::int32_t* const first = grid.cells + std::size_t{4} * static_cast<std::size_t>(nodes.index[at]);
    for (std::size_t pair = 0; pair < kPairs; ++pair)
        addPair(alongX, nodes.weights[(slot * kPairs + pair) * kLanes + lane], first + offsets[pair]);
}

void SplatBody(const BodyNodes& nodes, const BodyGrid& grid, std::size_t begin, std::size_t end)
{
    const std::size_t width = hn::Lanes(Tag());
    const auto count = static_cast<std::size_t>(nodes.nodes);
    const std::array<std::size_t, kPairs> offsets = pairOffsets(grid);
    SplatNodes ready;
    for (std::size_t block = begin; block < end; ++block)
        for (std::size_t lane = 0; lane < kLanes; lane += width) {
            const float* const hairs = nodes.hair + block * kLanes + lane;
            const Lanes hair = loaded(hairs);
            if (!any(hair > 0.0F))
                continue;
            for (std::size_t node = kFirstBodyNode; node < count; node += kNodesAtOnce) {
                const std::size_t slots = std::min(kNodesAtOnce, count - node);
                for (std::size_t slot = 0; slot < slots; ++slot) {
                    const std::size_t at = (block * count + node + slot) * StrandBlocks::kNodeStride + lane;
                    prepareSplat(grid, nodeAt(nodes, at), hair, slot, ready);
                }
                for (std::size_t i = 0; i < width; ++i) {
                    if (hairs[i] == 0.0F)
                        continue;
                    for (std::size_t slot = 0; slot < slots; ++slot)
                        addNode(grid, offsets, ready, slot, i);
                }
            }
        }
}

/// Where nodes of kLanes strands are in the grid, and what it holds there.
struct BodyAtNodes
{
    HWY_ALIGN std::int32_t index[kNodesAtOnce * kLanes]; ///< [node][lane]: the cell,
    HWY_ALIGN float t[kNodesAtOnce * 3 * kLanes];        ///< [node][3][lane]: and where in it, 0..1.
    HWY_ALIGN float values[kNodesAtOnce * kLanes * 4];   ///< [node][lane][4]: hair and its momentum.
};

HWY_INLINE void locate(const BodyGrid& grid, const Lanes3& p, std::size_t slot, BodyAtNodes& nodes)
{
    const CellOfNode cell = cellOf(grid, p);
    hn::Store(cell.index, IntTag(), nodes.index + slot * kLanes);
    stored3(cell.t, nodes.t + slot * 3 * kLanes);
}

/// The two cells along x between the four pairs around a node.
HWY_INLINE CellPair alongX(const std::int32_t* HWY_RESTRICT first, const std::array<std::size_t, kPairs>& offsets,
                           float y, float z)
{
    const auto alongY = [&](std::size_t pair) {
        const CellPair low = pairAt(first + offsets[pair]);
        return plus(low, pairAt(first + offsets[pair + 1]) - low, y);
    };
    const CellPair front = alongY(0);
    return plus(front, alongY(2) - front, z);
}

/// `slot`: which of the nodes made ready.
HWY_INLINE void readNode(const BodyGrid& grid, const std::array<std::size_t, kPairs>& offsets, std::size_t slot,
                         std::size_t lane, BodyAtNodes& nodes)
{
    const std::size_t at = slot * kLanes + lane;
    const float* HWY_RESTRICT const t = nodes.t + slot * 3 * kLanes + lane;
    const CellPair all = alongX(grid.cells + std::size_t{4} * static_cast<std::size_t>(nodes.index[at]), offsets,
                                t[kLanes], t[2 * kLanes]);
    stored(firstCell(all) + (secondCell(all) - firstCell(all)) * quadOf(t[0]), nodes.values + 4 * at);
}

void ReadBody(const BodyNodes& nodes, const BodyGrid& grid, float* out, std::size_t begin, std::size_t end)
{
    const auto count = static_cast<std::size_t>(nodes.nodes);
    const std::array<std::size_t, kPairs> offsets = pairOffsets(grid);
    BodyAtNodes read;
    for (std::size_t block = begin; block < end; ++block)
        for (std::size_t lane = 0; lane < kLanes; lane += hn::Lanes(Tag()))
            for (std::size_t node = 0; node < count; ++node) {
                locate(grid, loaded3(nodes.positions + (block * count + node) * StrandBlocks::kNodeStride + lane), 0,
                       read);
                for (std::size_t i = 0; i < hn::Lanes(Tag()); ++i)
                    readNode(grid, offsets, 0, i, read);
                Lanes hair;
                Lanes3 momentum;
                hn::LoadInterleaved4(Tag(), read.values, hair.v, momentum.x.v, momentum.y.v, momentum.z.v);
                stored(hair, out + (block * count + node) * kLanes + lane);
            }
}

/// The slope of the hair at a node, per cell, into slope[axis * kLanes].
HWY_INLINE void readSlope(const BodyGrid& grid, const std::array<std::size_t, kPairs>& offsets, std::size_t slot,
                          std::size_t lane, const BodyAtNodes& nodes, float* HWY_RESTRICT slope)
{
    const std::int32_t* const first =
        grid.cells + std::size_t{4} * static_cast<std::size_t>(nodes.index[slot * kLanes + lane]);
    const float* HWY_RESTRICT const t = nodes.t + slot * 3 * kLanes + lane;
    const float x = t[0];
    const float y = t[kLanes];
    const float z = t[2 * kLanes];
    const CellPair low = pairAt(first);
    const CellPair lowBehind = pairAt(first + offsets[2]);
    const CellPair rise = pairAt(first + offsets[1]) - low;
    const CellPair riseBehind = pairAt(first + offsets[3]) - lowBehind;
    const CellPair front = plus(low, rise, y);
    const CellPair depth = plus(lowBehind, riseBehind, y) - front;
    const CellPair all = plus(front, depth, z);
    const CellPair up = plus(rise, riseBehind - rise, z);
    const auto between = [x](const CellPair& pair) {
        const float before = firstOf(firstCell(pair));
        return before + (firstOf(secondCell(pair)) - before) * x;
    };
    slope[0] = firstOf(secondCell(all) - firstCell(all));
    slope[kLanes] = between(up);
    slope[2 * kLanes] = between(depth);
}

constexpr float kDenseFriction = 0.12F; ///< Fraction of the velocity against hair that is too dense that a step takes.
/// Greatest friction: over the steps of a grid it takes no more than all of the velocity.
constexpr float kMostFriction = 0.16F;
constexpr float kSettlingSteps = 20.0F; ///< Steps without motion after which a strand's contact no longer changes.
constexpr float kSlowChange = 0.015F;   ///< Greatest change of the contact of a node at rest, for each grid.
constexpr float kChangePerM = 450.0F;   ///< What is added to that for each metre that the node moves in a step.

/// Where hair is `above` what it may be, the direction out of it, as long as the contact is strong; 0 where hair is
/// equally dense all around, and elsewhere.
HWY_INLINE Lanes3 outOfDense(const BodyGrid& grid, const std::array<std::size_t, kPairs>& offsets, std::size_t slot,
                             const BodyAtNodes& nodes, Lanes hair, Lanes above, Lanes much)
{
    HWY_ALIGN float aboves[kLanes];
    HWY_ALIGN float slopes[3 * kLanes] = {};
    stored(above, aboves);
    for (std::size_t i = 0; i < hn::Lanes(Tag()); ++i)
        if (aboves[i] > 0.0F)
            readSlope(grid, offsets, slot, i, nodes, slopes + i);
    constexpr float kEven = 0.25F; // Slope of a cell, as a fraction of what it holds, that tells a direction.
    const Lanes3 slope = loaded3(slopes);
    const Lanes even = hair * kEven;
    return slope * (much * -1.0F / root(most(dot(slope, slope) + even * even, 1.0F)));
}

/// Applies the hair around to nodes that moved by `velocity` in the last step: changes their velocity and contact.
/// Returns whether any is in contact with hair. `wasDense`: whether any node of the block was; else `contact` is 0 and
/// stays unread where that does not change.
HWY_INLINE bool meetHair(const BodyGrid& grid, const std::array<std::size_t, kPairs>& offsets, const BodyGains& gains,
                         const BodyAtNodes& nodes, std::size_t slot, Lanes perRest, const Lanes3& velocity, Lanes still,
                         bool wasDense, float* HWY_RESTRICT previous, float* HWY_RESTRICT contact)
{
    Lanes hair;
    Lanes3 momentum;
    hn::LoadInterleaved4(Tag(), nodes.values + slot * kLanes * 4, hair.v, momentum.x.v, momentum.y.v, momentum.z.v);
    const Yes awake = still < kStillSteps;
    const Lanes3 around = momentum * (kBodyFastestM / most(hair, 1.0F));
    const Lanes above = hair * perRest - (1.0F + kBodyDeadBand);
    Lanes friction(gains.friction);
    Lanes3 outward{0.0F, 0.0F, 0.0F};
    const bool isDense = any(above > 0.0F);
    if (isDense) {
        const Lanes much = clamped(above * (1.0F / kBodyRange), 0.0F, 1.0F) * gains.contact;
        friction = least(friction + much * kDenseFriction, kMostFriction);
        outward = outOfDense(grid, offsets, slot, nodes, hair, above, much);
    }
    const Lanes3 taken = (around - velocity) * (friction * static_cast<float>(kStepsAGrid));
    stored3(loaded3(previous) - select(awake, taken, Lanes3{0.0F, 0.0F, 0.0F}), previous);
    if (!isDense && !wasDense)
        return false;
    const Lanes3 before = loaded3(contact);
    const Lanes3 change = outward - before;
    const Lanes change2 = dot(change, change);
    if (any(change2 > 0.0F)) {
        // A contact that answered at once to every tenth of a millimetre, a grid late, would swing for ever.
        const Lanes limit =
            select(still >= kSettlingSteps, 0.0F, kSlowChange + root(dot(velocity, velocity)) * kChangePerM);
        outward = before + change * least(Lanes(1.0F), limit / root(most(change2, 1e-12F)));
    }
    stored3(outward, contact);
    return any(dot(outward, outward) > 0.0F);
}

void PushBody(const BodyNodes& nodes, const BodyGrid& grid, const BodyPush& push, std::size_t begin, std::size_t end)
{
    const std::size_t width = hn::Lanes(Tag());
    const auto count = static_cast<std::size_t>(nodes.nodes);
    const std::array<std::size_t, kPairs> offsets = pairOffsets(grid);
    BodyAtNodes read;
    for (std::size_t block = begin; block < end; ++block) {
        bool isDense = false;
        bool isWhole = true;
        for (std::size_t lane = 0; lane < kLanes; lane += width) {
            const Lanes still = loaded(push.still + block * push.stillStride + lane);
            if (all(still >= kStillSteps)) {
                isWhole = false;
                continue;
            }
            for (std::size_t node = kFirstPushedNode; node < count; node += kNodesAtOnce) {
                const std::size_t slots = std::min(kNodesAtOnce, count - node);
                const std::size_t row = block * count + node;
                for (std::size_t slot = 0; slot < slots; ++slot)
                    locate(grid, nodeAt(nodes, (row + slot) * StrandBlocks::kNodeStride + lane).position, slot, read);
                for (std::size_t slot = 0; slot < slots; ++slot)
                    for (std::size_t i = 0; i < width; ++i)
                        readNode(grid, offsets, slot, i, read);
                for (std::size_t slot = 0; slot < slots; ++slot) {
                    const std::size_t at = (row + slot) * StrandBlocks::kNodeStride + lane;
                    const Lanes perRest = loaded(push.perRest + (row + slot) * kLanes + lane) * push.densityPerUnit;
                    isDense |= meetHair(grid, offsets, push.gains, read, slot, perRest, nodeAt(nodes, at).velocity,
                                        still, push.dense[block] != 0, push.previous + at, push.contact + at);
                }
            }
        }
        push.dense[block] = isDense || (!isWhole && push.dense[block] != 0) ? 1 : 0;
    }
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hairpaint::sim {

HWY_EXPORT(BoundsOfBody);
HWY_EXPORT(SplatBody);
HWY_EXPORT(ReadBody);
HWY_EXPORT(PushBody);

BodyBounds boundsOfBody(const BodyNodes& nodes, std::size_t begin, std::size_t end)
{
    return HWY_DYNAMIC_DISPATCH(BoundsOfBody)(nodes, begin, end);
}

void splatBody(const BodyNodes& nodes, const BodyGrid& grid, std::size_t begin, std::size_t end)
{
    HWY_DYNAMIC_DISPATCH(SplatBody)(nodes, grid, begin, end);
}

void readBody(const BodyNodes& nodes, const BodyGrid& grid, float* out, std::size_t begin, std::size_t end)
{
    HWY_DYNAMIC_DISPATCH(ReadBody)(nodes, grid, out, begin, end);
}

void pushBody(const BodyNodes& nodes, const BodyGrid& grid, const BodyPush& push, std::size_t begin, std::size_t end)
{
    HWY_DYNAMIC_DISPATCH(PushBody)(nodes, grid, push, begin, end);
}

} // namespace hairpaint::sim
#endif
