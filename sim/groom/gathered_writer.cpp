// Course, tail, and what the maps make of it.
#include "sim/groom/gathered_writer.h"

#include "sim/groom/braid_path.h"
#include "sim/groom/curve_constants.h"
#include "sim/groom/gathering.h"

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

void GatheredWriter::write(std::uint32_t slot, const RootChance& chance, const RootValues& values,
                           const HairVariation& own, const StrandStyle& style)
{
    const RootSet& roots = m_inputs.roots;
    const GroupSettings& settings = m_inputs.settings;
    const Gathering& gathering = m_inputs.gathering;
    const Gathering::TieState& tie = gathering.tieOf(gathering.numberOf(slot));
    const bool isBun = tie.tie.form == TieForm::Bun;
    const BraidKind kind = isBun ? kCoilKind : lacedKind(static_cast<BraidKind>(m_inputs.kinds[slot]));
    const bool isAlongCore = kind != BraidKind::None && tie.core != kNoCentre;
    const GatheredLay::Course course =
        tie.lay.courseOf(roots.face[slot], roots.positionHd[slot], chance.coatHeight, isAlongCore);
    const float seen = values.curl > 0.0F ? seenOverCut(settings, values.curl, values.curlSize) : 1.0F;
    const float cutM = style.lengthM / seen;
    Waiting& hair = m_hairs[m_count];
    hair.slot = slot;
    hair.style = style;
    hair.own = own;
    hair.followed = gathering.followed(slot);
    hair.clump = 0.0F;
    const std::span<glm::vec3> nodes = std::span(hair.nodesHd).first(m_nodes);
    const float tautM = cutM > course.tautM ? tie.lay.layTaut(course, cutM, nodes) : cutM;
    const float freeM = (cutM - tautM) * seen;
    if (!(freeM > 0.0F)) {
        tie.lay.layToward(course, cutM, nodes);
        hair.style.lengthM = cutM;
        hair.style.turns = hair.style.curlRadiusM = 0.0F;
        store(hair, kNoCentre, false);
        return;
    }
    hair.style.braidStart = static_cast<float>(m_ring) / static_cast<float>(m_nodes - 1);
    if (isAlongCore) {
        const float coreFreeM = tie.coreFreeM;
        tie.lay.layTail(course, coreFreeM, nodes);
        const float start = hair.style.braidStart;
        applyBraid(settings, kind, wispChanceOf(roots.seed, roots.rankOfSlot[slot]),
                   {.scalpM = tautM, .lengthM = coreFreeM, .radiusM = braidRadiusM(settings, coreFreeM)}, hair.style);
        hair.style.braidStart = start;
        if (isBun) {
            const float turns = coilTurns(tie.tie.bunRadiusM, coreFreeM);
            tie.lay.layCoil(kCoilHeight * tie.tie.bunRadiusM * coilPathFraction(turns), nodes.subspan(m_ring));
            hair.style.braidTaper = 0;
            hair.style.braidRadiusM = tie.tie.bunRadiusM;
            hair.style.braidTurns = turns;
        }
        hair.followed = {.basis = {tie.core, tie.core, tie.core}, .weights = {1.0F, 0.0F, 0.0F}};
        store(hair, tie.core, !isBun);
        return;
    }
    tie.lay.layTail(course, freeM, nodes);
    hair.style.lengthM = tautM + freeM;
    if (settings.turnsMode != TurnsMode::PerHair)
        hair.style.turns *= freeM / style.lengthM;
    hang(hair, values);
}

void GatheredWriter::hang(Waiting& hair, const RootValues& values)
{
    const RootSet& roots = m_inputs.roots;
    const GroupSettings& settings = m_inputs.settings;
    const Gathering& gathering = m_inputs.gathering;
    const std::size_t lane = m_count;
    const StrandBlocks behind(static_cast<int>(m_nodes - m_ring));
    behind.write(m_nodesHd, lane, std::span(hair.nodesHd).subspan(m_ring, m_nodes - m_ring));
    const std::uint32_t leader = gathering.leaderOf(hair.slot, m_inputs.locks, settings.locks.ragged);
    const std::uint32_t leaderSlot = roots.basisSlot[leader];
    const BasisStyles& basis = gathering.basis();
    const bool isFollowing = hair.followed.weights[0] > 0.0F && basis[BasisQuantity::SegmentLength][leader] > 0.0F;
    m_clump.clump[lane] = 0.0F;
    if (isFollowing && leaderSlot != hair.slot && !hair.own.isFlyaway) {
        // Value of the curl map from which on hair gathers by all of the group's amount.
        constexpr float kCurled = 0.2F;
        const float gathered = settings.curl.gather * std::min(values.curl / kCurled, 1.0F);
        const float own = m_inputs.maps[MapSlot::Clump].scalar(roots.uv[hair.slot]);
        const float clump = 1.0F - (1.0F - own) * (1.0F - gathered);
        const bool isInStep = settings.turnsMode == TurnsMode::Coils && hair.style.turns > 0.0F;
        if (clump > 0.0F || isInStep) {
            const RootChance chance = chanceOf(roots.seed, roots.rankOfSlot[leaderSlot]);
            hair.style.phase += (chance.phase - hair.style.phase) * (isInStep ? 1.0F : clump);
        }
        if (isInStep || clump > kTailKeepsStep)
            hair.own = variationOf(settings.variation, roots.seed, roots.rankOfSlot[leaderSlot]);
        m_clump.clump[lane] = clump;
        m_clump.segmentM[lane] =
            (hair.style.lengthM > 0.0F) ? glm::length(hair.nodesHd[m_ring + 1] - hair.nodesHd[m_ring]) : 0.0F;
        m_clump.basisSegmentM[lane] = basis[BasisQuantity::SegmentLength][leader];
        for (std::size_t axis = 0; axis < 3; ++axis)
            m_clump.leaderNormal.at(axis)[lane] = roots.normalHd[leaderSlot][static_cast<int>(axis)];
        const float* from = basis.restPositions.data() + behind.index(leader, 0);
        for (std::size_t row = 0; row < (m_nodes - m_ring) * 3; ++row)
            m_basisHd[row * kLanes + lane] = from[row * kLanes];
        if (clump > 0.0F && hair.followed.basis[0] != leader) {
            const auto [weights, nearest] = std::pair(hair.followed.weights, hair.followed.basis);
            hair.followed = {.basis = {leader, nearest[0], nearest[1]},
                             .weights = {clump, (1.0F - clump) * weights[0], (1.0F - clump) * weights[1]}};
            const float sum = hair.followed.weights[0] + hair.followed.weights[1] + hair.followed.weights[2];
            for (float& weight : hair.followed.weights)
                weight /= sum;
        } else if (clump > 0.0F) {
            for (std::size_t k = 0; k < RootSet::kNeighbours; ++k)
                hair.followed.weights[k] += ((k == 0 ? 1.0F : 0.0F) - hair.followed.weights[k]) * clump;
        }
    }
    if (++m_count == kLanes)
        finish();
}

void GatheredWriter::finish()
{
    if (m_count == 0)
        return;
    m_clump.nodes = static_cast<int>(m_nodes - m_ring);
    m_clump.nodesHd = m_nodesHd.data();
    m_clump.basisHd = m_basisHd.data();
    m_clump.locks = m_inputs.settings.locks;
    if (std::ranges::any_of(m_clump.clump, [](float clump) { return clump > 0.0F; }))
        clumpLanes(m_clump);
    const StrandBlocks behind(m_clump.nodes);
    for (std::size_t lane = 0; lane < m_count; ++lane) {
        Waiting& hair = m_hairs[lane];
        hair.clump = m_clump.clump[lane];
        varyCurl(hair.own, hair.style);
        behind.read(m_nodesHd, lane, std::span(hair.nodesHd).subspan(m_ring, m_nodes - m_ring));
        const bool isLong =
            glm::length(hair.nodesHd[m_ring + 1] - hair.nodesHd[m_ring]) * static_cast<float>(m_clump.nodes - 1) >=
            kShortestMovingTailM;
        store(hair, kNoCentre, isLong && hair.followed.weights[0] > 0.0F);
    }
    m_clump.clump.fill(0.0F);
    m_count = 0;
}

void GatheredWriter::store(const Waiting& hair, std::uint32_t centre, bool isTailed)
{
    const std::size_t local = hair.slot - m_firstSlot;
    StrandStyle style = hair.style;
    style.wisp = static_cast<std::uint8_t>(style.wisp | StrandStyle::kTautBit);
    m_chunk.hairs.set(local);
    m_chunk.drawn.set(local, hair.style.lengthM >= kShortestDrawnM);
    m_chunk.gathered.set(local);
    m_chunk.tailed.set(local, isTailed);
    m_chunk.styles[local] = style;
    m_chunk.clump[local] = hair.clump;
    m_chunk.braidCentre[local] = centre;
    if (!m_inputs.locks.isOfBasis())
        m_chunk.lockLeader[local] = m_inputs.roots.neighbours[hair.slot][0];
    m_chunk.segmentLengths[local] = 0.0F;
    if (!m_chunk.cornrows.empty())
        m_chunk.cornrows[local] = {};
    if (m_chunk.followed.empty())
        m_chunk.followed.resize(kChunkSlots);
    m_chunk.followed[local] = isTailed ? hair.followed : Followed{};
    StrandBlocks(static_cast<int>(m_nodes)).write(m_chunk.restPositions, local, std::span(hair.nodesHd).first(m_nodes));
}

} // namespace hairpaint::sim
