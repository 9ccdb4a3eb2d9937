// First which slots are hairs, then what those look like.
#include "sim/groom/chunk_builder.h"

#include "sim/groom/braid_path.h"
#include "sim/groom/rest_shape.h"
#include "sim/groom/strand_style.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hairpaint::sim {

namespace {

RootFrame rootFrame(const RootSet& roots, std::uint32_t slot)
{
    return {roots.positionHd[slot], roots.normalHd[slot]};
}

/// How far two hairs of one length go the same way, 0..1: across a parting no lock gathers.
float agreementOf(std::span<const glm::vec3> a, std::span<const glm::vec3> b)
{
    const glm::vec3 reachA = a.back() - a.front();
    const glm::vec3 reachB = b.back() - b.front();
    const float product = std::sqrt(glm::dot(reachA, reachA) * glm::dot(reachB, reachB));
    return product > 0.0F ? std::clamp(2.0F * glm::dot(reachA, reachB) / product, 0.0F, 1.0F) : 0.0F;
}

/// Evaluates hairs into one chunk; those that are laid together wait for finish().
class ChunkWriter
{
public:
    ChunkWriter(const ChunkInputs& inputs, std::size_t chunkIndex, StrandChunk& chunk)
        : m_inputs(inputs), m_chunk(chunk), m_firstSlot(static_cast<std::uint32_t>(chunkIndex * kChunkSlots)),
          m_blocks(inputs.settings.nodesPerHair), m_nodes(static_cast<std::size_t>(inputs.settings.nodesPerHair)),
          m_mostPassed(Lay::mostPassed(inputs.settings.nodesPerHair)), m_lay(inputs.lay, inputs.settings.nodesPerHair)
    {}

    void write(std::uint32_t slot, float density)
    {
        const RootSet& roots = m_inputs.roots;
        const RootChance chance = chanceOf(roots.seed, roots.rankOfSlot[slot]);
        const RootValues values = valuesAt(m_inputs.maps, roots.uv[slot]);
        StrandStyle style = styleOf(m_inputs.settings, values, chance, roots.threshold(slot) / density);
        const bool isDrawn = style.lengthM >= kShortestDrawnM;
        if (!isDrawn)
            style.detail = StrandStyle{}.detail;
        if (isDrawn && m_inputs.kinds[slot] != 0) {
            const std::uint32_t centre = m_inputs.braids.centreOf(roots, slot, m_inputs.kinds[slot]);
            if (centre != kNoCentre)
                return braid(slot, style, chance, centre);
        }
        m_lay.add(layRootOf(roots, slot, chance), style.lengthM);
        m_laid[m_waiting++] = {slot, style};
        if (m_lay.isFull())
            finish();
    }

    void finish()
    {
        m_lay.lay();
        for (std::size_t i = 0; i < m_waiting; ++i) {
            const std::uint32_t slot = m_laid[i].slot;
            const std::span<glm::vec3> nodes = std::span(m_buffer).first(m_nodes);
            m_lay.read(i, nodes);
            std::ranges::copy(m_lay.passed(i), passedBy(slot).begin());
            gather(slot, m_laid[i].style, nodes);
        }
        m_lay.clear();
        m_waiting = 0;
    }

    /// Of a hair that else stays as it is.
    void colour(std::uint32_t slot)
    {
        setColours(coloursAt(m_inputs.maps, m_inputs.roots.uv[slot]), m_chunk.styles[slot - m_firstSlot]);
    }

    void clear(std::uint32_t slot)
    {
        std::ranges::fill(std::span(m_buffer).first(m_nodes), glm::vec3(0.0F));
        store(slot, {}, {});
        m_chunk.hairs.reset(slot - m_firstSlot);
        m_chunk.drawn.reset(slot - m_firstSlot);
    }

private:
    struct Laid
    {
        std::uint32_t slot = 0;
        StrandStyle style;
    };
    /// What a hair follows beside the hairs around it.
    struct Followed
    {
        float clump = 0.0F;
        std::uint32_t centre = kNoCentre;
    };

    [[nodiscard]] std::span<std::int32_t> passedBy(std::uint32_t slot)
    {
        return std::span(m_chunk.passed).subspan((slot - m_firstSlot) * m_mostPassed, m_mostPassed);
    }

    void braid(std::uint32_t slot, StrandStyle style, const RootChance& chance, std::uint32_t centre)
    {
        const RootSet& roots = m_inputs.roots;
        const float centreLengthM = m_inputs.basisLengthM[centre];
        const float scalpM = braidRest(rootFrame(roots, slot), rootFrame(roots, roots.basisSlot[centre]), centreLengthM,
                                       std::span(m_buffer).first(m_nodes));
        applyBraid(m_inputs.settings, static_cast<BraidKind>(m_inputs.kinds[slot]), chance, scalpM, centreLengthM,
                   style);
        std::ranges::fill(passedBy(slot), SkinBand::kNone);
        store(slot, style, {.centre = centre});
    }

    /// A laid hair to its lock.
    void gather(std::uint32_t slot, StrandStyle style, std::span<glm::vec3> nodes)
    {
        const RootSet& roots = m_inputs.roots;
        const std::uint32_t basisIndex = roots.neighbours[slot][0];
        const std::uint32_t basis = roots.basisSlot[basisIndex];
        float clump = basis == slot ? 0.0F : m_inputs.maps[MapSlot::Clump].scalar(roots.uv[slot]);
        if (clump > 0.0F) {
            const std::span<const glm::vec3> basisNodes = basisRest(basisIndex);
            clump *= agreementOf(nodes, basisNodes);
            clumpRest(basisNodes, m_inputs.basis.segmentLengths[basisIndex], clump,
                      style.lengthM / static_cast<float>(m_nodes - 1), nodes);
            // Hairs that lie together curl together: a ringlet is one curl of many hairs.
            const float basisPhase = chanceOf(roots.seed, roots.rankOfSlot[basis]).phase;
            style.phase = basisPhase + (style.phase - basisPhase) * (1.0F - clump);
        }
        store(slot, style, {.clump = clump});
    }

    /// As it is laid; neighbours are as often as not of one lock.
    std::span<const glm::vec3> basisRest(std::uint32_t basisIndex)
    {
        const std::span<glm::vec3> nodes = std::span(m_basisBuffer).first(m_nodes);
        if (basisIndex != m_basisRead)
            m_blocks.read(m_inputs.basis.restPositions, basisIndex, nodes);
        m_basisRead = basisIndex;
        return nodes;
    }

    /// With its nodes from the buffer.
    void store(std::uint32_t slot, const StrandStyle& style, const Followed& followed)
    {
        const std::size_t local = slot - m_firstSlot;
        m_chunk.hairs.set(local);
        m_chunk.drawn.set(local, style.lengthM >= kShortestDrawnM);
        m_chunk.styles[local] = style;
        m_chunk.clump[local] = followed.clump;
        m_chunk.braidCentre[local] = followed.centre;
        m_chunk.segmentLengths[local] = style.lengthM / static_cast<float>(m_nodes - 1);
        m_blocks.write(m_chunk.restPositions, local, std::span(m_buffer).first(m_nodes));
    }

    const ChunkInputs& m_inputs;
    StrandChunk& m_chunk;
    std::uint32_t m_firstSlot;
    StrandBlocks m_blocks;
    std::size_t m_nodes;
    std::size_t m_mostPassed;
    Lay m_lay;
    std::array<Laid, kLanes> m_laid; ///< That m_lay holds, in its order.
    std::size_t m_waiting = 0;
    std::array<glm::vec3, kMostNodes> m_buffer{};
    std::array<glm::vec3, kMostNodes> m_basisBuffer{};
    std::uint32_t m_basisRead = kNoCentre; ///< Whose rest shape m_basisBuffer holds.
};

std::shared_ptr<StrandChunk> emptyChunk(int nodes)
{
    auto chunk = std::make_shared<StrandChunk>();
    chunk->styles.resize(kChunkSlots);
    chunk->passed.assign(kChunkSlots * Lay::mostPassed(nodes), SkinBand::kNone);
    chunk->clump.resize(kChunkSlots);
    chunk->restPositions.resize(StrandBlocks(nodes).floatsFor(kBlocksPerChunk));
    chunk->segmentLengths.resize(kChunkSlots);
    chunk->braidCentre.assign(kChunkSlots, kNoCentre);
    return chunk;
}

} // namespace

std::shared_ptr<const StrandChunk> rebuildChunk(const ChunkInputs& inputs,
                                                const std::shared_ptr<const StrandChunk>& before,
                                                std::size_t chunkIndex, const ChangedSlots& dirty, SlotSet& rebuilt)
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
        densities[local] = inputs.maps[MapSlot::Density].scalar(roots.uv[slot]);
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
    if (hairs.none())
        return nullptr;

    const std::shared_ptr<StrandChunk> chunk =
        kept.any() ? std::make_shared<StrandChunk>(*before) : emptyChunk(inputs.settings.nodesPerHair);
    ChunkWriter writer(inputs, chunkIndex, *chunk);
    dirty.look.forEachInChunk(chunkIndex, [&](std::uint32_t slot) {
        if (chunk->hairs[slot - firstSlot] && !dirty.hairs.contains(slot))
            writer.colour(slot);
    });
    dirty.hairs.forEachInChunk(chunkIndex, [&](std::uint32_t slot) {
        const std::size_t local = slot - firstSlot;
        if (hairs[local])
            writer.write(slot, densities[local]);
        else if (chunk->hairs[local])
            writer.clear(slot);
    });
    writer.finish();
    return chunk;
}

} // namespace hairpaint::sim
