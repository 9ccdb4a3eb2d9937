// Preparing and positioning dependent hairs.
#include "sim/motion/dependents.h"

#include "sim/base/parallel.h"
#include "sim/groom/strand_curve.h"
#include "sim/motion/head_motion.h"
#include "sim/solver/dependents_kernel.h"
#include "sim/solver/strand_constants.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hairpaint::sim {

namespace {

constexpr std::size_t kDependentBlocksAtOnce = 8;
constexpr std::size_t kBasisBlocksAtOnce = 64;
constexpr float kStranger = 0.25F; ///< A basis hair that agrees less lies to another side, or is laid otherwise.

constexpr float kLeastOfLength = 0.3F; ///< A basis hair that is shorter is a stranger, too.

constexpr float kLoner = 0.5F;          ///< Long hair that agrees less with any is none that lies so on purpose.
constexpr float kHangingAloneM = 0.15F; ///< Shorter hair may well carry itself.
constexpr float kHangsAlike = 0.75F;    ///< One of less than this fraction of its length tells not how it hangs.
constexpr float kSameLengthM = 1e-4F;   ///< A braid and the strand that it follows that differ by less do not.

/// On the curve through the nodes, as it is drawn: a chord would lie in what the strand bends around.
glm::vec3 between(std::span<const glm::vec3> nodes, std::size_t segment, float t)
{
    const glm::vec3 b = nodes[segment];
    const glm::vec3 c = nodes[segment + 1];
    const glm::vec3 a = segment > 0 ? nodes[segment - 1] : b * 2.0F - c;
    const glm::vec3 d = segment + 2 < nodes.size() ? nodes[segment + 2] : c * 2.0F - b;
    return b + ((c - a) * 0.5F + (a - b * 2.5F + c * 2.0F - d * 0.5F + ((d - a) * 0.5F + (b - c) * 1.5F) * t) * t) * t;
}

/// How much one of another length tells of how a hair of `lengthM` moves, 0..1, never nothing.
float likeness(float lengthM, float basisLengthM)
{
    const float ratio = basisLengthM < lengthM ? basisLengthM / lengthM : lengthM / basisLengthM;
    const float square = ratio * ratio;
    return square > 1e-4F ? square : 1e-4F;
}

glm::vec3 inWorld(const RigidMotion& world, glm::vec3 p)
{
    glm::vec3 q;
    for (int i = 0; i < 3; ++i) {
        const auto& row = world.rows[static_cast<std::size_t>(i)];
        q[i] = row[0] * p.x + row[1] * p.y + row[2] * p.z + world.offset[static_cast<std::size_t>(i)];
    }
    return q;
}

} // namespace

void Dependents::prepare(const Groom& groom, const ColliderSet& colliders, bool everything)
{
    m_chunks.resize(groom.chunks.size());
    m_positioned.clear();
    std::vector<std::uint8_t> changed;
    const bool basisDiffers = m_leads.update(groom, changed);
    std::vector<std::uint32_t> stale;
    std::vector<std::uint32_t> kept;
    for (std::size_t i = 0; i < groom.chunks.size(); ++i) {
        if (groom.chunks[i] && groom.packedChunk[i] >= 0)
            m_positioned.push_back(static_cast<std::uint32_t>(i));
        if (everything || m_chunks[i].styles != groom.chunks[i])
            stale.push_back(static_cast<std::uint32_t>(i));
        else if (basisDiffers && groom.chunks[i])
            kept.push_back(static_cast<std::uint32_t>(i));
    }
    parallelFor(kept.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            followChangedBasis(groom, changed, kept[i]);
    });
    parallelFor(stale.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            prepareChunk(groom, colliders, stale[i]);
    });
}

void Dependents::followChangedBasis(const Groom& groom, const std::vector<std::uint8_t>& changed, std::size_t index)
{
    Chunk& chunk = m_chunks[index];
    if (chunk.weights.empty() || groom.isOfTails)
        return;
    const std::size_t firstSlot = index * kChunkSlots;
    const std::size_t count = std::min<std::size_t>(kChunkSlots, groom.roots->neighbours.size() - firstSlot);
    const std::vector<std::uint16_t> parted = std::exchange(chunk.parted, {});
    auto nextParted = parted.begin();
    for (std::size_t slot = 0; slot < count; ++slot) {
        const bool wasParted = nextParted != parted.end() && *nextParted == slot;
        if (wasParted)
            ++nextParted; // It depends on basis hairs further away, too.
        const std::array<std::uint32_t, RootSet::kNeighbours>& nearest = groom.roots->neighbours[firstSlot + slot];
        if (chunk.styles->drawn[slot] && !chunk.styles->gathered[slot] &&
            (wasParted || changed[leaderOf(groom, index, slot)] != 0 ||
             std::ranges::any_of(nearest, [&](std::uint32_t basis) { return changed[basis] != 0; })))
            follow(groom, index, slot);
    }
}

void Dependents::follow(const Groom& groom, std::size_t index, std::size_t slot)
{
    Chunk& chunk = m_chunks[index];
    const StrandChunk& styles = *chunk.styles;
    const RootSet& roots = *groom.roots;
    const auto last = static_cast<std::size_t>(groom.nodes - 1);
    const std::array<std::uint32_t, RootSet::kNeighbours>& nearest = roots.neighbours[index * kChunkSlots + slot];
    const float lengthM = styles.segmentLengths[slot] * static_cast<float>(last);
    const HairLead own = leadOf(groom, styles.restPositions, slot, lengthM, 1.0F / lengthM);
    if (!chunk.rest.empty())
        for (std::size_t node = 0; node <= last; ++node)
            groom.blocks().setNode(chunk.rest, slot, node, groom.blocks().node(styles.restPositions, slot, node));
    // What stubble does tells nothing of how long hair beside it falls.
    const bool hangs = lengthM > kHangingAloneM;
    const float leastM = (hangs ? kHangsAlike : kLeastOfLength) * lengthM;
    const auto agreed = [&](std::uint32_t basis) {
        const HairLead& lead = m_leads[basis];
        return lead.lengthM < leastM ? 0.0F : agreement(own, lead);
    };
    std::array<float, RootSet::kNeighbours> agreements{};
    std::ranges::transform(nearest, agreements.begin(), agreed);
    if (!chunk.followed.empty())
        chunk.followed[slot] = nearest;
    const auto followAlone = [&](std::uint32_t basis) {
        makeFollowed(groom, index);
        chunk.followed[slot] = {basis, nearest[0], nearest[1]};
        chunk.weights[slot] = {1.0F, 0.0F, 0.0F};
        setClump(groom, index, slot, 0.0F);
    };
    const bool isLeftLong =
        hangs && std::ranges::all_of(nearest, [&](std::uint32_t basis) { return m_leads[basis].lengthM < leastM; });
    if (isLeftLong || std::ranges::max(agreements) <= kStranger)
        chunk.parted.push_back(static_cast<std::uint16_t>(slot));
    if (isLeftLong)
        if (const std::optional<std::uint32_t> other =
                m_leads.nearestAsLong(roots, roots.positionHd[index * kChunkSlots + slot], leastM)) {
            followAlone(*other);
            layAlong(groom, index, slot, *other);
            return;
        }
    if (std::ranges::max(agreements) <= kStranger) {
        std::uint32_t best = nearest[0];
        float most = kStranger;
        for (const std::uint32_t basis : nearest)
            for (const std::uint32_t next : roots.neighbours[roots.basisSlot[basis]])
                if (const float agreement = agreed(next); agreement > most) {
                    most = agreement;
                    best = next;
                }
        if (most > kStranger) {
            followAlone(best);
            if (most < kLoner && hangs)
                layAlong(groom, index, slot, best);
            return;
        }
    }
    std::array<float, RootSet::kNeighbours>& weights = chunk.weights[slot];
    weights = roots.weights[index * kChunkSlots + slot];
    if (std::ranges::max(agreements) < kLoner && hangs) {
        // Nothing holds it there: it hangs as that one does which is most like it.
        const auto first = static_cast<std::size_t>(std::ranges::max_element(agreements) - agreements.begin());
        layAlong(groom, index, slot, nearest[first]);
        for (std::size_t k = 0; k < weights.size(); ++k)
            weights[k] = k == first ? 1.0F : 0.0F;
        setClump(groom, index, slot, 0.0F);
        return;
    }
    for (std::size_t k = 0; k < weights.size(); ++k)
        // A hair that lies to another side is none to follow.
        weights[k] *= likeness(lengthM, m_leads[nearest[k]].lengthM) * std::max(agreements[k], 1e-3F);
    // The mean of two sides is neither: beside the foremost, those count that lie as it does.
    const auto foremost = static_cast<std::size_t>(std::ranges::max_element(weights) - weights.begin());
    for (std::size_t k = 0; k < weights.size(); ++k)
        if (k != foremost)
            weights[k] *= agreement(m_leads[nearest[foremost]], m_leads[nearest[k]]);
    const std::uint32_t leader = leaderOf(groom, index, slot);
    const float clump = styles.clump[slot] * likeness(lengthM, m_leads[leader].lengthM) *
                        (leader == nearest[0] ? agreements[0] : agreed(leader));
    if (leader != nearest[0])
        return followLock(groom, index, slot, clump);
    const float together = weights[0] + weights[1] + weights[2];
    for (std::size_t k = 0; k < weights.size(); ++k)
        weights[k] += ((k == 0 ? together : 0.0F) - weights[k]) * clump;
    setClump(groom, index, slot, styles.clump[slot]);
}

void Dependents::followGiven(const Groom& groom, std::size_t index, std::size_t slot)
{
    Chunk& chunk = m_chunks[index];
    const StrandChunk& styles = *chunk.styles;
    const StrandBlocks layout = groom.blocks();
    const Followed& given = styles.followed[slot];
    makeFollowed(groom, index);
    chunk.followed[slot] = given.basis;
    chunk.weights[slot] = given.weights;
    const glm::vec3 toFirst =
        layout.node(groom.basis->restPositions, given.basis[0], 0) - layout.node(styles.restPositions, slot, 0);
    const std::size_t rows = chunk.lanes.size() / (kBlocksPerChunk * kLanes);
    for (std::size_t axis = 0; axis < 3; ++axis)
        chunk.lanes[rowIndex(slot, kDependentClumpX + axis, rows)] =
            toFirst[static_cast<int>(axis)] * styles.clump[slot];
}

void Dependents::followLock(const Groom& groom, std::size_t index, std::size_t slot, float clump)
{
    Chunk& chunk = m_chunks[index];
    std::array<float, RootSet::kNeighbours>& weights = chunk.weights[slot];
    const std::array<std::uint32_t, RootSet::kNeighbours>& nearest =
        groom.roots->neighbours[index * kChunkSlots + slot];
    makeFollowed(groom, index);
    chunk.followed[slot] = {leaderOf(groom, index, slot), nearest[0], nearest[1]};
    const float two = weights[0] + weights[1];
    const float rest = two > 0.0F ? (1.0F - clump) / two : 0.0F;
    weights = {clump, weights[0] * rest, weights[1] * rest};
    setClump(groom, index, slot, chunk.styles->clump[slot]);
}

std::uint32_t Dependents::leaderOf(const Groom& groom, std::size_t index, std::size_t slot)
{
    const std::vector<std::uint32_t>& leaders = groom.chunks[index]->lockLeader;
    return leaders.empty() ? groom.roots->neighbours[index * kChunkSlots + slot][0] : leaders[slot];
}

void Dependents::makeFollowed(const Groom& groom, std::size_t index)
{
    Chunk& chunk = m_chunks[index];
    if (!chunk.followed.empty())
        return;
    const RootSet& roots = *groom.roots;
    const auto first = roots.neighbours.begin() + static_cast<std::ptrdiff_t>(index * kChunkSlots);
    chunk.followed.assign(first, first + std::min<std::ptrdiff_t>(kChunkSlots, roots.neighbours.end() - first));
}

/// Gives a hair the rest shape of a basis hair, at its own root and length.
void Dependents::layAlong(const Groom& groom, std::size_t index, std::size_t slot, std::uint32_t basis)
{
    Chunk& chunk = m_chunks[index];
    const StrandChunk& styles = *chunk.styles;
    if (chunk.rest.empty())
        chunk.rest = styles.restPositions;
    const StrandBlocks layout = groom.blocks();
    const glm::vec3 root = layout.node(styles.restPositions, slot, 0);
    const glm::vec3 basisRoot = layout.node(groom.basis->restPositions, basis, 0);
    const float longer =
        styles.segmentLengths[slot] / std::max((*groom.basis)[BasisQuantity::SegmentLength][basis], 1e-6F);
    for (std::size_t node = 1; node < static_cast<std::size_t>(groom.nodes); ++node)
        layout.setNode(chunk.rest, slot, node,
                       root + (layout.node(groom.basis->restPositions, basis, node) - basisRoot) * longer);
}

void Dependents::setClump(const Groom& groom, std::size_t index, std::size_t slot, float clump)
{
    const RootSet& roots = *groom.roots;
    const std::size_t root = index * kChunkSlots + slot;
    const glm::vec3 toNearest =
        roots.positionHd[roots.basisSlot[leaderOf(groom, index, slot)]] - roots.positionHd[root];
    Chunk& chunk = m_chunks[index];
    const std::size_t rows = chunk.lanes.size() / (kBlocksPerChunk * kLanes);
    for (std::size_t axis = 0; axis < 3; ++axis)
        chunk.lanes[rowIndex(slot, kDependentClumpX + axis, rows)] = toNearest[static_cast<int>(axis)] * clump;
}

void Dependents::prepareChunk(const Groom& groom, const ColliderSet& colliders, std::size_t index)
{
    Chunk& chunk = m_chunks[index];
    chunk.styles = groom.chunks[index];
    chunk.braided.clear();
    if (!chunk.styles || !groom.roots)
        return;
    const std::size_t rows = dependentRows(colliders);
    chunk.lanes.assign(kBlocksPerChunk * rows * kLanes, 0.0F);
    chunk.weights.resize(kChunkSlots);
    chunk.followed.clear();
    chunk.parted.clear();
    chunk.rest.clear();
    const StrandChunk& styles = *chunk.styles;
    const std::size_t firstSlot = index * kChunkSlots;
    for (std::size_t slot = 0; slot < kChunkSlots; ++slot) {
        if (!styles.drawn[slot] || styles.gathered[slot] || firstSlot + slot >= groom.roots->neighbours.size())
            continue;
        const auto row = [&](int number) -> float& {
            return chunk.lanes[rowIndex(slot, static_cast<std::size_t>(number), rows)];
        };
        const float segment = styles.segmentLengths[slot];
        row(kDependentSegment) = segment;
        if (groom.isOfTails)
            followGiven(groom, index, slot);
        else
            follow(groom, index, slot);
        if (!styles.braidCentre.empty() && styles.braidCentre[slot] != kNoCentre)
            chunk.braided.push_back(static_cast<std::uint16_t>(slot));
        float height = 0.0F;
        for (std::size_t k = 0; k < RootSet::kNeighbours; ++k)
            height += groom.roots->weights[firstSlot + slot][k] *
                      (*groom.basis)[BasisQuantity::Height][groom.roots->neighbours[firstSlot + slot][k]];
        std::array<glm::vec3, kMostNodes> rest;
        const std::span<glm::vec3> nodes = std::span(rest).first(static_cast<std::size_t>(groom.nodes));
        groom.blocks().read(styles.restPositions, slot, nodes);
        const StrandStyle& style = styles.styles[slot];
        // A curl winds about its nodes at its radius; an S lies beside them.
        const float windingM =
            style.curlRadiusM * (coilsOf(groom.settings) != nullptr ? 1.0F - groom.settings.curl.flatness : 1.0F);
        row(kDependentClearance) =
            style.turns > 0.0F ? skinClearance(colliders, nodes, kSkinClearanceM + windingM) : kSkinClearanceM;
        for (int c = 0; c < colliders.count; ++c) {
            const float scale = strandScale(colliders.items[static_cast<std::size_t>(c)], nodes.first(2),
                                            coatM(height, groom.settings.physics.volumeM, segment));
            row(kDependentScale + c) = scale * scale;
        }
    }
}

void Dependents::findDisplacements(const Groom& groom, const StrandState& state, float fraction)
{
    const auto nodes = static_cast<std::size_t>(groom.nodes);
    m_displacements.resize(state.blocks * kLanes * nodes * kBasisFloats);
    const BasisStyles& basis = *groom.basis;
    const AlignedFloats& before = state.before();
    const AlignedFloats& now = state.now();
    parallelFor(state.blocks, kBasisBlocksAtOnce, [&](std::size_t begin, std::size_t end) {
        for (std::size_t block = begin; block < end; ++block) {
            const std::uint32_t wanted = basis.wanted[block];
            for (std::size_t lane = 0; lane < kLanes; ++lane) {
                const float length =
                    basis[BasisQuantity::SegmentLength][block * kLanes + lane] * static_cast<float>(nodes - 1);
                const bool solved = ((wanted >> lane) & 1U) != 0 && length > 0.0F;
                const float stretch = state.field(block * kLanes + lane, kStretch);
                const float perLength = solved ? 1.0F / displacementScaleM(length) : 0.0F;
                float* out = m_displacements.data() + (block * kLanes + lane) * nodes * kBasisFloats;
                std::size_t at = groom.blocks().index(block * kLanes + lane, 0);
                const std::size_t root = at;
                for (std::size_t node = 0; node < nodes; ++node, at += StrandBlocks::kNodeStride, out += kBasisFloats) {
                    for (std::size_t axis = 0; axis < 3; ++axis) {
                        const std::size_t index = at + axis * StrandBlocks::kAxisStride;
                        const float moment = before[index] + (now[index] - before[index]) * fraction;
                        out[axis] = (moment - basis.restPositions[index]) * perLength;
                        out[4 + axis] = (basis.restPositions[index] -
                                         basis.restPositions[root + axis * StrandBlocks::kAxisStride]) *
                                        perLength;
                    }
                    out[3] = 0.0F;
                    out[kBasisStretch] = stretch;
                }
            }
        }
    });
}

void Dependents::writeBraided(const Groom& groom, const Chunk& chunk, const RigidMotion& world, float detail,
                              float* out) const
{
    const auto nodes = static_cast<std::size_t>(groom.nodes);
    const BasisStyles& basis = *groom.basis;
    std::array<glm::vec3, kMostNodes> rest;
    std::array<glm::vec3, kMostNodes> centre;
    for (const std::uint16_t slot : chunk.braided) {
        if (!(chunk.styles->styles[slot].detail < detail))
            continue;
        const std::size_t basisIndex = chunk.styles->braidCentre[slot];
        groom.blocks().read(chunk.styles->restPositions, slot, std::span(rest).first(nodes));
        groom.blocks().read(basis.restPositions, basisIndex, std::span(centre).first(nodes));
        const float length =
            displacementScaleM(basis[BasisQuantity::SegmentLength][basisIndex] * static_cast<float>(nodes - 1));
        const float* displacement = m_displacements.data() + basisIndex * nodes * kBasisFloats;
        for (std::size_t i = 0; i < nodes; ++i, displacement += kBasisFloats)
            centre[i] += glm::vec3(displacement[0], displacement[1], displacement[2]) * length;
        // Along the scalp to the centre's root, then evenly along the centre to its tip.
        const auto last = static_cast<int>(nodes - 1);
        const int gathered = std::clamp(
            static_cast<int>(std::floor(chunk.styles->styles[slot].braidStart * static_cast<float>(last) + 0.5F)), 0,
            last);
        // It stands beside the root of the strand that it follows, if that is borrowed, and above it.
        constexpr float kRisesOver = 2.0F; // Segments of the strand.
        const auto begin = static_cast<std::size_t>(gathered);
        // A cornrow keeps to the skin up to its end, and its tail follows the strand from there.
        const CornrowHair row = chunk.styles->cornrows.empty() ? CornrowHair{} : chunk.styles->cornrows[slot];
        const bool isRow = row.end > 0.0F;
        const float leaves = isRow ? row.end * static_cast<float>(last) : static_cast<float>(gathered);
        const glm::vec3 beside = (isRow ? row.endHd : rest[begin]) - centre[0];
        const glm::vec3 normal = groom.roots->normalHd[groom.roots->basisSlot[basisIndex]];
        const glm::vec3 above = normal * glm::dot(beside, normal);
        const float restM = isRow ? row.tailM : glm::length(rest[static_cast<std::size_t>(last)] - rest[begin]);
        const float longer = std::abs(restM - length) < kSameLengthM ? 1.0F : restM / length;
        float* at = out + groom.blocks().index(slot, 0);
        for (int i = 0; i <= last; ++i, at += StrandBlocks::kNodeStride) {
            glm::vec3 p = rest[static_cast<std::size_t>(i)];
            if (static_cast<float>(i) > leaves) {
                const auto behind = static_cast<float>(last) - leaves;
                const float along = (static_cast<float>(i) - leaves) * static_cast<float>(last) / behind;
                const auto segment = static_cast<std::size_t>(std::min(static_cast<int>(along), last - 1));
                p = between(std::span(centre).first(nodes), segment, along - static_cast<float>(segment));
                if (longer != 1.0F)
                    p = centre[0] + (p - centre[0]) * longer;
                p += beside - above * std::min(along / kRisesOver, 1.0F);
            }
            StrandBlocks::store(at, world.identity ? p : inWorld(world, p));
        }
    }
}

void Dependents::write(const Groom& groom, const StrandState& state, const ColliderSet& colliders, float fraction,
                       const HeadPose& pose, const Neck& neck, GroupFrame& frame)
{
    const std::size_t chunkFloats = groom.blocks().floatsFor(kBlocksPerChunk);
    frame.positions.resize(static_cast<std::size_t>(groom.packedChunks) * chunkFloats);
    if (!groom.roots || m_positioned.empty())
        return;
    findDisplacements(groom, state, fraction);
    DependentsTask common;
    common.nodes = groom.nodes;
    common.displacements = m_displacements.data();
    common.colliders = &colliders;
    common.beginsInAir = groom.isOfTails;
    common.world = worldOfHead(pose);
    common.neck = neckTurn(neck, pose);
    common.detail = frame.detail;
    parallelFor(m_positioned.size() * kBlocksPerChunk, kDependentBlocksAtOnce, [&](std::size_t begin, std::size_t end) {
        for (std::size_t at = begin; at < end;) {
            const std::size_t index = m_positioned[at / kBlocksPerChunk];
            const std::size_t chunkBegin = at - at % kBlocksPerChunk;
            const std::size_t until = std::min(end, chunkBegin + kBlocksPerChunk);
            const Chunk& chunk = m_chunks[index];
            DependentsTask task = common;
            task.neighbours =
                chunk.followed.empty() ? groom.roots->neighbours.data() + index * kChunkSlots : chunk.followed.data();
            task.weights = chunk.weights.data();
            task.rest = (chunk.rest.empty() ? chunk.styles->restPositions : chunk.rest).data();
            task.lanes = chunk.lanes.data();
            task.leastDetail = chunk.styles->leastDetail.data();
            task.out = frame.positions.data() + static_cast<std::size_t>(groom.packedChunk[index]) * chunkFloats;
            positionDependents(task, at - chunkBegin, until - chunkBegin);
            at = until;
        }
    });
    parallelFor(m_positioned.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Chunk& chunk = m_chunks[m_positioned[i]];
            const auto packed = static_cast<std::size_t>(groom.packedChunk[m_positioned[i]]);
            if (!chunk.braided.empty())
                writeBraided(groom, chunk, common.world, frame.detail, frame.positions.data() + packed * chunkFloats);
        }
    });
}

} // namespace hairpaint::sim
