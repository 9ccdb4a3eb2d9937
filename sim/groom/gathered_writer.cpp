// Lanes of hairs, and what the maps make of them.
#include "sim/groom/gathered_writer.h"

#include "sim/groom/braid_path.h"
#include "sim/groom/curve_constants.h"
#include "sim/groom/gathering.h"
#include "sim/groom/lane_store.h"

#include <algorithm>
#include <numbers>

namespace hairpaint::sim {

namespace {

constexpr float kShortestMovingTailM = 0.005F; ///< A shorter end behind the ring does not move.
constexpr float kFewestTurns = 1.7F;           ///< Fewest turns of a bun's rope, with which it covers its tie,
constexpr float kMostTurns = 3.0F;             ///< and the most, with which the rope is still seen.
constexpr float kTailKeepsStep = 0.3F;         ///< Clump above which a hair curls as its lock does.

/// Radius of the rope's path at the foot of a coil, in units of the coil's.
float coilPathFraction(float turns)
{
    return 1.0F - kCoilMeridian / (kCoilMeridian + turns * kCoilApart);
}

/// Turns of a bun of `radiusM` that hair of `freeM` makes: the longer the hair the more, and the finer the rope.
float coilTurns(float radiusM, float freeM)
{
    // Mean radius of the path's circles over the dome, as a fraction of the coil's radius.
    constexpr float kMeanCircle = 0.45F;
    return std::clamp(freeM / (2.0F * std::numbers::pi_v<float> * kMeanCircle * std::max(radiusM, 1e-4F)), kFewestTurns,
                      kMostTurns);
}

} // namespace

GatheredWriter::GatheredWriter(const ChunkInputs& inputs, std::size_t chunkIndex, StrandChunk& chunk)
    : m_inputs(inputs), m_chunk(chunk), m_firstSlot(static_cast<std::uint32_t>(chunkIndex * kChunkSlots)),
      m_nodes(static_cast<std::size_t>(inputs.settings.nodesPerHair)),
      m_ring(static_cast<std::size_t>(ringNode(inputs.settings.nodesPerHair)))
{}

GatheredWriter::Batch& GatheredWriter::batchOf(std::uint16_t tie)
{
    const auto at = std::ranges::find(m_batches, tie, [](const std::unique_ptr<Batch>& batch) { return batch->tie; });
    if (at != m_batches.end())
        return **at;
    m_batches.push_back(std::make_unique<Batch>());
    m_batches.back()->tie = tie;
    return *m_batches.back();
}

void GatheredWriter::write(std::uint32_t slot, const RootChance& chance, const RootValues& values,
                           const HairVariation& own, const StrandStyle& style)
{
    const RootSet& roots = m_inputs.roots;
    const GroupSettings& settings = m_inputs.settings;
    const Gathering& gathering = m_inputs.gathering;
    Batch& batch = batchOf(gathering.numberOf(slot));
    const Gathering::TieState& tie = gathering.tieOf(batch.tie);
    const std::size_t lane = batch.count++;
    Waiting& hair = batch.hairs[lane];
    hair.slot = slot;
    hair.style = style;
    hair.own = own;
    hair.followed = gathering.followed(slot);
    hair.curl = values.curl;
    hair.looseM = style.lengthM;
    hair.kind = BraidKind::None;
    if (tie.core != kNoCentre)
        hair.kind = tie.tie.form == TieForm::Bun ? kCoilKind : lacedKind(static_cast<BraidKind>(m_inputs.kinds[slot]));
    const bool isAlongCore = hair.kind != BraidKind::None;
    const float seen = values.curl > 0.0F ? seenOverCut(settings, values.curl, values.curlSize) : 1.0F;
    tie.lay.put(batch.lanes, lane, roots.face[slot], roots.positionHd[slot]);
    batch.lanes.chance[lane] = chance.coatHeight;
    batch.lanes.isCore[lane] = isAlongCore ? 1.0F : 0.0F;
    batch.lanes.cutM[lane] = style.lengthM / seen;
    batch.lanes.seen[lane] = seen;
    batch.lanes.givenFreeM[lane] = isAlongCore ? tie.coreFreeM : 0.0F;
    if (batch.count == kLanes)
        lay(batch);
}

void GatheredWriter::finish()
{
    for (const std::unique_ptr<Batch>& batch : m_batches)
        if (batch->count > 0)
            lay(*batch);
}

void GatheredWriter::lay(Batch& batch)
{
    m_inputs.gathering.tieOf(batch.tie).lay.lay(batch.lanes, static_cast<int>(m_nodes), m_nodesHd);
    m_clump.clump.fill(0.0F);
    for (std::size_t lane = 0; lane < batch.count; ++lane) {
        Waiting& hair = batch.hairs[lane];
        if (!(batch.lanes.freeM[lane] > 0.0F)) {
            hair.style.lengthM = batch.lanes.cutM[lane];
            hair.style.turns = hair.style.curlRadiusM = 0.0F;
            store(batch, lane, 0.0F, kNoCentre, false);
            continue;
        }
        hair.style.braidStart = static_cast<float>(m_ring) / static_cast<float>(m_nodes - 1);
        if (hair.kind != BraidKind::None)
            lace(batch, lane);
        else
            hang(batch, lane);
    }
    m_clump.nodes = static_cast<int>(m_nodes - m_ring);
    m_clump.nodesHd = m_nodesHd.data() + m_ring * StrandBlocks::kNodeStride;
    m_clump.basisHd = m_basisHd.data();
    m_clump.locks = m_inputs.settings.locks;
    if (std::ranges::any_of(m_clump.clump, [](float clump) { return clump > 0.0F; }))
        clumpLanes(m_clump);
    for (std::size_t lane = 0; lane < batch.count; ++lane) {
        Waiting& hair = batch.hairs[lane];
        if (!(batch.lanes.freeM[lane] > 0.0F) || hair.kind != BraidKind::None)
            continue;
        varyCurl(hair.own, hair.style);
        const bool isLong =
            glm::length(node(lane, m_ring + 1) - node(lane, m_ring)) * static_cast<float>(m_clump.nodes - 1) >=
            kShortestMovingTailM;
        store(batch, lane, m_clump.clump[lane], kNoCentre, isLong && hair.followed.weights[0] > 0.0F);
    }
    storeLanes(
        StrandBlocks(static_cast<int>(m_nodes)), m_nodesHd, batch.count,
        [&](std::size_t lane) { return std::size_t{batch.hairs.at(lane).slot - m_firstSlot}; }, m_chunk.restPositions);
    batch.count = 0;
}

void GatheredWriter::lace(Batch& batch, std::size_t lane)
{
    const RootSet& roots = m_inputs.roots;
    const GroupSettings& settings = m_inputs.settings;
    const Gathering::TieState& tie = m_inputs.gathering.tieOf(batch.tie);
    Waiting& hair = batch.hairs[lane];
    const float start = hair.style.braidStart;
    applyBraid(
        settings, hair.kind, wispChanceOf(roots.seed, roots.rankOfSlot[hair.slot]),
        {.scalpM = batch.lanes.tautM[lane], .lengthM = tie.coreFreeM, .radiusM = braidRadiusM(settings, tie.coreFreeM)},
        hair.style);
    hair.style.braidStart = start;
    const bool isBun = tie.tie.form == TieForm::Bun;
    if (isBun) {
        const float turns = coilTurns(tie.tie.bunRadiusM, tie.coreFreeM);
        const float heightM = kCoilHeight * tie.tie.bunRadiusM * coilPathFraction(turns);
        for (std::size_t i = m_ring; i < m_nodes; ++i)
            StrandBlocks::store(
                m_nodesHd.data() + i * StrandBlocks::kNodeStride + lane,
                tie.lay.onCoil(heightM, static_cast<float>(i - m_ring) / static_cast<float>(m_nodes - 1 - m_ring)));
        hair.style.braidTaper = 0;
        hair.style.braidRadiusM = tie.tie.bunRadiusM;
        hair.style.braidTurns = turns;
    }
    hair.followed = {.basis = {tie.core, tie.core, tie.core}, .weights = {1.0F, 0.0F, 0.0F}};
    store(batch, lane, 0.0F, tie.core, !isBun);
}

void GatheredWriter::hang(Batch& batch, std::size_t lane)
{
    const RootSet& roots = m_inputs.roots;
    const GroupSettings& settings = m_inputs.settings;
    const Gathering& gathering = m_inputs.gathering;
    Waiting& hair = batch.hairs[lane];
    const float freeM = batch.lanes.freeM[lane];
    hair.style.lengthM = batch.lanes.tautM[lane] + freeM;
    if (settings.turnsMode != TurnsMode::PerHair)
        hair.style.turns *= freeM / hair.looseM;
    const std::uint32_t leader = gathering.leaderOf(hair.slot, m_inputs.locks, settings.locks.ragged);
    const std::uint32_t leaderSlot = roots.basisSlot[leader];
    const BasisStyles& basis = gathering.basis();
    const bool isFollowing = hair.followed.weights[0] > 0.0F && basis[BasisQuantity::SegmentLength][leader] > 0.0F;
    if (!isFollowing || leaderSlot == hair.slot || hair.own.isFlyaway)
        return;
    // Value of the curl map from which on hair gathers by all of the group's amount.
    constexpr float kCurled = 0.2F;
    const float gathered = settings.curl.gather * std::min(hair.curl / kCurled, 1.0F);
    const float own = m_inputs.maps[MapSlot::Clump].scalar(roots.uv[hair.slot]);
    const float clump = 1.0F - (1.0F - own) * (1.0F - gathered);
    const bool isInStep = settings.turnsMode == TurnsMode::Coils && hair.style.turns > 0.0F;
    if (clump > 0.0F || isInStep) {
        const RootChance chance = chanceOf(roots.seed, roots.rankOfSlot[leaderSlot]);
        hair.style.phase += (chance.phase - hair.style.phase) * (isInStep ? 1.0F : clump);
    }
    if (isInStep || clump > kTailKeepsStep)
        hair.own = curlVariationOf(settings.variation, roots.seed, roots.rankOfSlot[leaderSlot]);
    if (!(clump > 0.0F))
        return;
    drawToLock(lane, leader, clump, glm::length(node(lane, m_ring + 1) - node(lane, m_ring)));
    if (hair.followed.basis[0] != leader) {
        const auto [weights, nearest] = std::pair(hair.followed.weights, hair.followed.basis);
        hair.followed = {.basis = {leader, nearest[0], nearest[1]},
                         .weights = {clump, (1.0F - clump) * weights[0], (1.0F - clump) * weights[1]}};
        const float sum = hair.followed.weights[0] + hair.followed.weights[1] + hair.followed.weights[2];
        for (float& weight : hair.followed.weights)
            weight /= sum;
    } else {
        for (std::size_t k = 0; k < RootSet::kNeighbours; ++k)
            hair.followed.weights[k] += ((k == 0 ? 1.0F : 0.0F) - hair.followed.weights[k]) * clump;
    }
}

void GatheredWriter::drawToLock(std::size_t lane, std::uint32_t leader, float clump, float segmentM)
{
    const RootSet& roots = m_inputs.roots;
    const BasisStyles& basis = m_inputs.gathering.basis();
    m_clump.clump[lane] = clump;
    m_clump.segmentM[lane] = segmentM;
    m_clump.basisSegmentM[lane] = basis[BasisQuantity::SegmentLength][leader];
    const glm::vec3 normal = roots.normalHd[roots.basisSlot[leader]];
    for (std::size_t axis = 0; axis < 3; ++axis)
        m_clump.leaderNormal.at(axis)[lane] = normal[static_cast<int>(axis)];
    const std::size_t behind = m_nodes - m_ring;
    const float* from = basis.restPositions.data() + StrandBlocks(static_cast<int>(behind)).index(leader, 0);
    for (std::size_t row = 0; row < behind * 3; ++row)
        m_basisHd[row * kLanes + lane] = from[row * kLanes];
}

void GatheredWriter::store(const Batch& batch, std::size_t lane, float clump, std::uint32_t centre, bool isTailed)
{
    const Waiting& hair = batch.hairs[lane];
    const std::size_t local = hair.slot - m_firstSlot;
    StrandStyle style = hair.style;
    style.wisp = static_cast<std::uint8_t>(style.wisp | StrandStyle::kTautBit);
    m_chunk.hairs.set(local);
    m_chunk.drawn.set(local, hair.style.lengthM >= kShortestDrawnM);
    m_chunk.gathered.set(local);
    m_chunk.tailed.set(local, isTailed);
    m_chunk.styles[local] = style;
    m_chunk.clump[local] = clump;
    m_chunk.braidCentre[local] = centre;
    if (!m_inputs.locks.isOfBasis())
        m_chunk.lockLeader[local] = m_inputs.roots.neighbours[hair.slot][0];
    m_chunk.segmentLengths[local] = 0.0F;
    if (!m_chunk.cornrows.empty())
        m_chunk.cornrows[local] = {};
    if (m_chunk.followed.empty())
        m_chunk.followed.resize(kChunkSlots);
    m_chunk.followed[local] = isTailed ? hair.followed : Followed{};
}

} // namespace hairpaint::sim
