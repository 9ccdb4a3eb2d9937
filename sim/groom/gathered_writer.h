// Evaluates the gathered hairs of one chunk.
#pragma once

#include "sim/groom/chunk_builder.h"
#include "sim/groom/clump_kernel.h"
#include "sim/groom/gather_kernel.h"
#include "sim/groom/strand_style.h"

#include <array>
#include <memory>
#include <vector>

namespace hairpaint::sim {

/// Hairs are kept until kLanes of one tie wait or finish() is called. One thread.
class GatheredWriter
{
public:
    GatheredWriter(const ChunkInputs& inputs, std::size_t chunkIndex, StrandChunk& chunk);

    /// `style`: what the hair's style would be if it were loose.
    void write(std::uint32_t slot, const RootChance& chance, const RootValues& values, const HairVariation& own,
               const StrandStyle& style);
    void finish();

private:
    struct Waiting
    {
        std::uint32_t slot = 0;
        StrandStyle style;
        HairVariation own;
        Followed followed;
        BraidKind kind = BraidKind::None; ///< What its tail goes along the tie's core as; None: it hangs.
        float curl = 0.0F;
        float looseM = 0.0F; ///< Length if it were loose.
    };
    /// Hairs of one tie.
    struct Batch
    {
        std::uint16_t tie = 0;
        std::size_t count = 0;
        std::array<Waiting, kLanes> hairs;
        GatherLanes lanes;
    };
    [[nodiscard]] Batch& batchOf(std::uint16_t tie);
    void lay(Batch& batch);
    /// The tail goes along the core of the tie, as part of a braid or a bun.
    void lace(Batch& batch, std::size_t lane);
    /// The tail hangs from the ring: prepares drawing it to its lock.
    void hang(Batch& batch, std::size_t lane);
    void drawToLock(std::size_t lane, std::uint32_t leader, float clump, float segmentM);
    /// Stores all of a hair but its nodes.
    void store(const Batch& batch, std::size_t lane, float clump, std::uint32_t centre, bool isTailed);
    [[nodiscard]] glm::vec3 node(std::size_t lane, std::size_t node) const
    {
        return StrandBlocks::load(m_nodesHd.data() + node * StrandBlocks::kNodeStride + lane);
    }

    const ChunkInputs& m_inputs;
    StrandChunk& m_chunk;
    std::uint32_t m_firstSlot;
    std::size_t m_nodes;
    std::size_t m_ring;
    std::vector<std::unique_ptr<Batch>> m_batches; ///< One a tie.
    ClumpTask m_clump;                             ///< Draws tails to their locks.
    std::array<float, std::size_t{kMostNodes} * StrandBlocks::kNodeStride> m_nodesHd{};
    std::array<float, std::size_t{kMostNodes} * StrandBlocks::kNodeStride> m_basisHd{};
};

} // namespace hairpaint::sim
