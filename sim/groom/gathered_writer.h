// Evaluates the gathered hairs of one chunk.
#pragma once

#include "sim/groom/chunk_builder.h"
#include "sim/groom/clump_kernel.h"
#include "sim/groom/strand_style.h"

#include <array>

namespace hairpaint::sim {

/// Hairs whose tails are drawn to locks are kept until kLanes of them wait or finish() is called. One thread.
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
        float clump = 0.0F;
        std::array<glm::vec3, kMostNodes> nodesHd{};
    };
    /// Prepares the tail of a hair that hangs from the ring and is not braided.
    void hang(Waiting& hair, const RootValues& values);
    void store(const Waiting& hair, std::uint32_t centre, bool isTailed);

    const ChunkInputs& m_inputs;
    StrandChunk& m_chunk;
    std::uint32_t m_firstSlot;
    std::size_t m_nodes;
    std::size_t m_ring;
    std::array<Waiting, kLanes> m_hairs;
    std::size_t m_count = 0;
    ClumpTask m_clump; ///< Draws the tails of the hairs that wait to their locks.
    std::array<float, std::size_t{kMostNodes} * StrandBlocks::kNodeStride> m_nodesHd{};
    std::array<float, std::size_t{kMostNodes} * StrandBlocks::kNodeStride> m_basisHd{};
};

} // namespace hairpaint::sim
