// First which slots are hairs, then what those look like.
#include "sim/groom/chunk_builder.h"

#include "sim/groom/braid_path.h"
#include "sim/groom/clump_kernel.h"
#include "sim/groom/gathered_writer.h"
#include "sim/groom/gathering.h"
#include "sim/groom/lane_store.h"
#include "sim/groom/rest_shape.h"
#include "sim/groom/strand_style.h"
#include "sim/groom/turn_kernel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace hairpaint::sim {

namespace {

RootFrame rootFrame(const RootSet& roots, std::uint32_t slot)
{
    return {roots.positionHd[slot], roots.normalHd[slot]};
}

/// Evaluates hairs into one chunk; those that are laid together wait for finish().
class ChunkWriter
{
public:
    ChunkWriter(const ChunkInputs& inputs, std::size_t chunkIndex, StrandChunk& chunk, PassedCells& passed)
        : m_inputs(inputs), m_chunk(chunk), m_passed(passed),
          m_firstSlot(static_cast<std::uint32_t>(chunkIndex * kChunkSlots)), m_blocks(inputs.settings.nodesPerHair),
          m_nodes(static_cast<std::size_t>(inputs.settings.nodesPerHair)),
          m_lay(inputs.lay, inputs.settings.nodesPerHair), m_look(inputs.settings, inputs.maps),
          m_varies(!inputs.hairline.isOff() || inputs.settings.variation != VariationSettings{})
    {}

    void write(std::uint32_t slot, float density)
    {
        const RootSet& roots = m_inputs.roots;
        const RootChance chance = chanceOf(roots.seed, roots.rankOfSlot[slot]);
        const RootValues values = valuesAt(m_inputs.maps, roots.uv[slot]);
        Laid& hair = m_laid[m_waiting];
        hair.slot = slot;
        if (m_varies)
            hair.own = ownOf(slot, values);
        StrandStyle& style = hair.style;
        style = styleOf(m_inputs.settings, values, chance, hair.own, roots.threshold(slot) / density);
        m_look.give(roots.uv[slot], hair.own, style);
        const bool isDrawn = style.lengthM >= kShortestDrawnM;
        if (!isDrawn)
            style.detail = StrandStyle{}.detail;
        if (isDrawn && m_inputs.gathering.numberOf(slot) != 0 && hair.own.babyM == 0.0F) {
            m_passed.put(slot, {});
            if (!m_gathered)
                m_gathered.emplace(m_inputs, chunkOf(slot), m_chunk);
            m_gathered->write(slot, chance, values, hair.own, style);
            return;
        }
        if (const Braid* braid = m_inputs.braids.of(slot); braid != nullptr && isDrawn && hair.own.babyM == 0.0F)
            return joinBraid(slot, style, *braid);
        hair.gathered = gatheredBy(values.curl);
        const LayRoot root = layRootOf(m_inputs.settings, roots, slot, chance,
                                       liftOf(m_inputs.settings, style.curlRadiusM, style.lengthM));
        if (!m_lay.add(root, style.lengthM)) {
            style.lengthM = 0.0F;
            style.detail = StrandStyle{}.detail;
        }
        ++m_waiting;
        if (m_lay.isFull())
            finish();
    }

    void finishAll()
    {
        finish();
        if (m_gathered)
            m_gathered->finish();
    }

    void finish()
    {
        m_lay.lay();
        constexpr float kKeepsStep = 0.3F; ///< Clump above which a hair curls as its lock does.
        const RootSet& roots = m_inputs.roots;
        const VariationSettings& variation = m_inputs.settings.variation;
        const std::span<float> nodesHd = m_lay.nodesHd();
        const LockSettings& locks = m_inputs.settings.locks;
        m_clump.nodes = m_inputs.settings.nodesPerHair;
        m_clump.nodesHd = nodesHd.data();
        m_turn.nodes = m_clump.nodes;
        m_turn.nodesHd = m_clump.nodesHd;
        m_clump.basisHd = m_basisHd.data();
        for (std::size_t i = 0; i < m_waiting; ++i)
            m_passed.put(m_laid[i].slot, m_lay.passed(i));
        if (locks.small > 0.0F && !m_inputs.locks.isOfBasis()) {
            bool any = false;
            for (std::size_t i = 0; i < m_waiting; ++i)
                any |= findSmallLock(i);
            m_clump.locks = {};
            if (any)
                clumpLanes(m_clump);
            m_clump.clump.fill(0.0F);
        }
        bool anyClumps = false;
        for (std::size_t i = 0; i < m_waiting; ++i)
            anyClumps |= findLock(i);
        m_clump.locks = locks;
        if (anyClumps)
            clumpLanes(m_clump);
        for (std::size_t i = 0; i < m_waiting; ++i) {
            Laid& hair = m_laid[i];
            const float clump = m_clump.clump[i];
            // Hairs that lie together curl together: a ringlet is one curl of many hairs.
            hair.style.phase += (hair.basisPhase - hair.style.phase) * (hair.isInStep ? 1.0F : clump);
            if (m_varies)
                varyCurl(hair.isInStep || clump > kKeepsStep ? curlVariationOf(variation, roots.seed, hair.basisRank)
                                                             : hair.own,
                         hair.style);
            if (m_varies && hair.own.isTurned())
                m_turn.turnLane(i, hair.own, clump, roots.frame(hair.slot), hair.style.lengthM);
            store(hair.slot, hair.style, {.clump = clump, .leader = hair.leader});
        }
        if (m_varies) {
            turnLanes(m_turn);
            m_turn.turns.fill(0.0F);
        }
        storeLanes(
            m_blocks, nodesHd, m_waiting,
            [this](std::size_t lane) { return std::size_t{m_laid.at(lane).slot - m_firstSlot}; },
            m_chunk.restPositions);
        m_clump.clump.fill(0.0F);
        m_lay.clear();
        m_waiting = 0;
    }

    /// Updates the look of a hair whose shape stays the same.
    void look(std::uint32_t slot)
    {
        const RootSet& roots = m_inputs.roots;
        StrandStyle& style = m_chunk.styles[slot - m_firstSlot];
        m_look.give(roots.uv[slot], m_varies ? ownOf(slot, {}) : HairVariation{}, style);
        if (style.braid != BraidKind::None)
            placeInWisp(m_inputs.settings, wispChanceOf(roots.seed, roots.rankOfSlot[slot]), style);
    }

    void clear(std::uint32_t slot)
    {
        std::ranges::fill(std::span(m_buffer).first(m_nodes), glm::vec3(0.0F));
        store(slot, {}, {});
        storeBuffer(slot);
        m_passed.put(slot, {});
        m_chunk.hairs.reset(slot - m_firstSlot);
        m_chunk.drawn.reset(slot - m_firstSlot);
    }

private:
    struct Laid
    {
        std::uint32_t slot = 0;
        StrandStyle style;
        HairVariation own;           ///< Neutral where no hair varies.
        float gathered = 0.0F;       ///< Clump, 0..1, from the group's CurlSettings::gather and its curl.
        std::uint32_t leader = 0;    ///< Basis hair that leads its lock.
        bool isInStep = false;       ///< Its curl's phase is its lock's, however little it clumps.
        float basisPhase = 0.0F;     ///< Curl phase of the basis hair that it clumps to, rad.
        std::uint32_t basisRank = 0; ///< Rank of that basis hair.
    };
    /// What a hair follows beside the hairs around it.
    struct RowMembership
    {
        float clump = 0.0F;
        std::uint32_t centre = kNoCentre;
        std::uint32_t leader = 0;
    };

    [[nodiscard]] HairVariation ownOf(std::uint32_t slot, const RootValues& values) const
    {
        return variationAt(m_inputs.settings, m_inputs.roots, m_inputs.hairline, slot,
                           lengthOf(m_inputs.settings, values.length) *
                               seenOverCut(m_inputs.settings, values.curl, values.curlSize));
    }

    void joinRow(std::uint32_t slot, StrandStyle style, const Braid& braid)
    {
        const RootSet& roots = m_inputs.roots;
        const CornrowJoin join = cornrowRest(rootFrame(roots, slot), *braid.row, braid.radiusM, braid.lengthM,
                                             std::span(m_buffer).first(m_nodes));
        applyBraid(m_inputs.settings, braid.kind, wispChanceOf(roots.seed, roots.rankOfSlot[slot]),
                   {.scalpM = join.scalpM, .lengthM = join.lengthM, .radiusM = braid.radiusM}, style);
        style.braidStart = join.start;
        style.phase = join.beforeM * style.braidTurns / join.lengthM;
        m_passed.put(slot, {});
        store(slot, style, {.centre = braid.basis, .leader = roots.neighbours[slot][0]});
        storeBuffer(slot);
        if (m_chunk.cornrows.empty())
            m_chunk.cornrows.resize(kChunkSlots);
        m_chunk.cornrows[slot - m_firstSlot] = {
            .end = join.end,
            .tailM = braid.lengthM,
            .endHd = onRow(*braid.row, braid.row->lengthM, kCornrowAboveRadii * braid.radiusM),
            .sideHd = braid.row->sideHd};
    }

    void joinBraid(std::uint32_t slot, StrandStyle style, const Braid& braid)
    {
        if (braid.row)
            return joinRow(slot, style, braid);
        const RootSet& roots = m_inputs.roots;
        const float scalpM =
            braidRest(rootFrame(roots, slot), rootFrame(roots, braid.root),
                      braidBeginsAboveM(braid.kind, braid.radiusM), braid.lengthM, std::span(m_buffer).first(m_nodes));
        applyBraid(m_inputs.settings, braid.kind, wispChanceOf(roots.seed, roots.rankOfSlot[slot]),
                   {.scalpM = scalpM, .lengthM = braid.lengthM, .radiusM = braid.radiusM}, style);
        m_passed.put(slot, {});
        store(slot, style, {.centre = braid.basis, .leader = roots.neighbours[slot][0]});
        storeBuffer(slot);
    }

    [[nodiscard]] float gatheredBy(float curl) const
    {
        /// Value of the curl map from which on hair gathers by all of the group's amount.
        constexpr float kCurled = 0.2F;
        return m_inputs.settings.curl.gather * std::min(curl / kCurled, 1.0F);
    }

    /// Prepares m_clump to draw a laid hair to a basis hair.
    void drawTo(std::size_t hair, std::uint32_t basisIndex, float clump)
    {
        m_clump.clump[hair] = clump;
        m_clump.segmentM[hair] = m_laid[hair].style.lengthM / static_cast<float>(m_nodes - 1);
        m_clump.basisSegmentM[hair] = m_inputs.basis[BasisQuantity::SegmentLength][basisIndex];
        if (m_inputs.settings.locks.flatness > 0.0F) {
            const glm::vec3 normal = m_inputs.roots.normalHd[m_inputs.roots.basisSlot[basisIndex]];
            for (std::size_t axis = 0; axis < 3; ++axis)
                m_clump.leaderNormal.at(axis)[hair] = normal[static_cast<int>(axis)];
        }
        const float* from = m_inputs.basis.restPositions.data() + m_blocks.index(basisIndex, 0);
        for (std::size_t row = 0; row < m_nodes * 3; ++row)
            m_basisHd[row * kLanes + hair] = from[row * kLanes];
    }

    /// Prepares drawing a hair to its small lock; returns whether it is drawn to one.
    bool findSmallLock(std::size_t hair)
    {
        const RootSet& roots = m_inputs.roots;
        const std::uint32_t slot = m_laid[hair].slot;
        const std::uint32_t nearest = roots.neighbours[slot][0];
        if (roots.basisSlot[nearest] == slot || m_laid[hair].own.isFlyaway)
            return false;
        drawTo(hair, nearest, m_inputs.settings.locks.small);
        return true;
    }

    /// Finds a hair's lock and prepares drawing it there; returns whether it is drawn to one.
    bool findLock(std::size_t hair)
    {
        const RootSet& roots = m_inputs.roots;
        const std::uint32_t slot = m_laid[hair].slot;
        const std::uint32_t leader = m_inputs.locks.leaderOf(roots, slot, m_inputs.settings.locks.ragged);
        const std::uint32_t leaderSlot = roots.basisSlot[leader];
        m_laid[hair].leader = leader;
        m_laid[hair].isInStep = false;
        m_laid[hair].basisPhase = 0.0F;
        if (leaderSlot == slot || m_laid[hair].own.isFlyaway)
            return false;
        float clump = m_inputs.maps[MapSlot::Clump].scalar(roots.uv[slot]);
        const float gathered = m_laid[hair].gathered;
        if (gathered > 0.0F) {
            // Hair that is short for its lock stays on its skin, else that would show between the locks.
            constexpr float kReaches = 4.0F;
            const glm::vec3 apart = roots.positionHd[leaderSlot] - roots.positionHd[slot];
            const float neededM = kReaches * std::sqrt(glm::dot(apart, apart));
            const float reach = std::min(1.0F, m_laid[hair].style.lengthM / std::max(neededM, 1e-6F));
            clump = 1.0F - (1.0F - clump) * (1.0F - gathered * reach);
        }
        m_laid[hair].isInStep = m_inputs.settings.turnsMode == TurnsMode::Coils && m_laid[hair].style.turns > 0.0F;
        if (clump <= 0.0F && !m_laid[hair].isInStep)
            return false;
        m_laid[hair].basisRank = roots.rankOfSlot[leaderSlot];
        m_laid[hair].basisPhase = chanceOf(roots.seed, roots.rankOfSlot[leaderSlot]).phase;
        if (clump > 0.0F)
            drawTo(hair, leader, clump);
        return clump > 0.0F;
    }

    /// Stores all of a hair but its nodes.
    void store(std::uint32_t slot, const StrandStyle& style, const RowMembership& followed)
    {
        const std::size_t local = slot - m_firstSlot;
        m_chunk.hairs.set(local);
        m_chunk.gathered.reset(local);
        m_chunk.tailed.reset(local);
        if (!m_chunk.followed.empty())
            m_chunk.followed[local] = {};
        if (!m_chunk.cornrows.empty())
            m_chunk.cornrows[local] = {};
        m_chunk.drawn.set(local, style.lengthM >= kShortestDrawnM);
        m_chunk.styles[local] = style;
        m_chunk.clump[local] = followed.clump;
        m_chunk.braidCentre[local] = followed.centre;
        if (!m_inputs.locks.isOfBasis())
            m_chunk.lockLeader[local] = followed.leader;
        m_chunk.segmentLengths[local] = style.lengthM / static_cast<float>(m_nodes - 1);
    }

    void storeBuffer(std::uint32_t slot)
    {
        m_blocks.write(m_chunk.restPositions, slot - m_firstSlot, std::span(m_buffer).first(m_nodes));
    }

    const ChunkInputs& m_inputs;
    StrandChunk& m_chunk;
    PassedCells& m_passed;
    std::uint32_t m_firstSlot;
    StrandBlocks m_blocks;
    std::size_t m_nodes;
    Lay m_lay;
    HairLook m_look;
    bool m_varies;
    std::array<Laid, kLanes> m_laid; ///< The hairs that m_lay holds, in its order.
    std::size_t m_waiting = 0;
    std::array<glm::vec3, kMostNodes> m_buffer{};
    ClumpTask m_clump; ///< Draws the hairs that m_lay holds to their locks; all clump is 0 between batches.
    TurnTask m_turn;   ///< Turns them as chance wants; none is turned between batches.
    std::array<float, std::size_t{kMostNodes} * StrandBlocks::kNodeStride> m_basisHd{};
    std::optional<GatheredWriter> m_gathered; ///< Larger than a cache: made for the first gathered hair.
};

std::shared_ptr<StrandChunk> emptyChunk(int nodes, bool hasLocks)
{
    auto chunk = std::make_shared<StrandChunk>();
    chunk->styles.resize(kChunkSlots);
    chunk->clump.resize(kChunkSlots);
    chunk->restPositions.resize(StrandBlocks(nodes).floatsFor(kBlocksPerChunk));
    chunk->segmentLengths.resize(kChunkSlots);
    chunk->braidCentre.assign(kChunkSlots, kNoCentre);
    if (hasLocks)
        chunk->lockLeader.assign(kChunkSlots, 0);
    return chunk;
}

void findLeastDetails(StrandChunk& chunk, const std::bitset<kBlocksPerChunk>& blocks)
{
    for (std::size_t block = 0; block < kBlocksPerChunk; ++block) {
        if (!blocks[block])
            continue;
        const auto styles = std::span(chunk.styles).subspan(block * kLanes, kLanes);
        chunk.leastDetail[block] = std::ranges::min_element(styles, {}, &StrandStyle::detail)->detail;
    }
}

} // namespace

float hairDensity(const VariationSettings& variation, const Hairline& hairline, const MapSamplers& maps,
                  const RootSet& roots, std::uint32_t slot)
{
    const float density = hairline.isOff() ? maps[MapSlot::Density].scalar(roots.uv[slot])
                                           : hairline.density(slot) * densityAtDepth(hairline.depth(slot));
    if (density == 0.0F)
        return 0.0F;
    return density * densityLeft(variation, roots.positionHd[slot]);
}

std::shared_ptr<const StrandChunk> rebuildChunk(const ChunkInputs& inputs,
                                                const std::shared_ptr<const StrandChunk>& before,
                                                std::size_t chunkIndex, const ChangedSlots& dirty, PassedCells& passed,
                                                SlotSet& rebuilt)
{
    const RootSet& roots = inputs.roots;
    const std::size_t firstSlot = chunkIndex * kChunkSlots;
    std::bitset<kChunkSlots> hairs = before ? before->hairs : std::bitset<kChunkSlots>{};
    std::bitset<kChunkSlots> kept = hairs;
    std::array<float, kChunkSlots> densities; // Written where read.
    bool differs = false;
    dirty.look.forEachInChunk(chunkIndex, [&](std::uint32_t slot) {
        if (hairs[slot - firstSlot]) {
            rebuilt.insert(slot);
            differs = true;
        }
    });
    dirty.hairs.forEachInChunk(chunkIndex, [&](std::uint32_t slot) {
        const std::size_t local = slot - firstSlot;
        densities[local] = hairDensity(inputs.settings.variation, inputs.hairline, inputs.maps, roots, slot);
        const bool isHair = roots.threshold(slot) < densities[local];
        if (isHair || hairs[local]) {
            rebuilt.insert(slot);
            differs = true;
        }
        hairs.set(local, isHair);
        kept.reset(local);
    });
    if (!differs)
        return before;
    if (hairs.none()) {
        dirty.hairs.forEachInChunk(chunkIndex, [&](std::uint32_t slot) { passed.put(slot, {}); });
        return nullptr;
    }

    const std::shared_ptr<StrandChunk> chunk =
        kept.any() ? std::make_shared<StrandChunk>(*before)
                   : emptyChunk(inputs.settings.nodesPerHair, !inputs.locks.isOfBasis());
    std::bitset<kBlocksPerChunk> touched;
    if (kept.none()) {
        touched.set();
        passed.startChunk(chunkIndex);
    }
    ChunkWriter writer(inputs, chunkIndex, *chunk, passed);
    dirty.look.forEachInChunk(chunkIndex, [&](std::uint32_t slot) {
        touched.set((slot - firstSlot) / kLanes);
        if (chunk->hairs[slot - firstSlot] && !dirty.hairs.contains(slot))
            writer.look(slot);
    });
    dirty.hairs.forEachInChunk(chunkIndex, [&](std::uint32_t slot) {
        const std::size_t local = slot - firstSlot;
        touched.set(local / kLanes);
        if (hairs[local])
            writer.write(slot, densities[local]);
        else if (chunk->hairs[local])
            writer.clear(slot);
    });
    writer.finishAll();
    findLeastDetails(*chunk, touched);
    if (chunk->gathered.none())
        chunk->followed.clear();
    if (std::ranges::all_of(chunk->cornrows, [](const CornrowHair& hair) { return hair == CornrowHair{}; }))
        chunk->cornrows.clear();
    return chunk;
}

} // namespace hairpaint::sim
