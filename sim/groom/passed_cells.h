// Over which cells of the field strands lie, to find those that lie otherwise where it differs.
#pragma once

#include "sim/groom/slot_set.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hairpaint::sim {

/// A list of cells a strand. Strands of different chunks may be written by different threads.
class PassedCells
{
public:
    /// Nobody has passed anything.
    void startOver(std::size_t strands, int nodes);
    /// All strands of a chunk that lie on something are about to be put.
    void startChunk(std::size_t chunk);
    /// `cells`: up to the first SkinBand::kNone, at most Lay::mostPassed(nodes).
    void put(std::size_t strand, std::span<const std::int32_t> cells);
    /// Adds the strands that passed one of these cells, of `cellCount` that there are. Reads lists only in chunks that
    /// came near one. Uses parallelFor.
    void findPassing(std::span<const std::uint32_t> cells, std::size_t cellCount, SlotSet& strands) const;

private:
    struct Chunk
    {
        std::vector<std::int32_t> lists; ///< [kChunkSlots][m_most]; empty where nobody has passed anything.
        /// A bit for every few neighbouring cells that a strand has passed, now or since renew().
        std::vector<std::uint64_t> near;
        std::size_t puts = 0; ///< Number of puts since renew().
    };
    [[nodiscard]] std::span<const std::int32_t> listOf(const Chunk& chunk, std::size_t local) const
    {
        return std::span(chunk.lists).subspan(local * m_most, m_most);
    }
    void renew(Chunk& chunk) const;

    std::size_t m_most = 0;
    std::vector<Chunk> m_chunks;
};

} // namespace hairpaint::sim
