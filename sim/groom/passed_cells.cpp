// Chunks that came near first, then their strands.
#include "sim/groom/passed_cells.h"

#include "sim/base/parallel.h"
#include "sim/groom/lay.h"

#include <algorithm>
#include <limits>

namespace hairpaint::sim {

namespace {

constexpr std::size_t kCellsPerBit = 8; ///< Cells in a row that share a bit of a chunk's summary.

/// One bit an index; grows as needed.
void insertBit(std::vector<std::uint64_t>& words, std::size_t index)
{
    if (index / 64 >= words.size())
        words.resize(index / 64 + 1, 0);
    words[index / 64] |= std::uint64_t{1} << (index % 64);
}

/// The words of a set that are not empty.
struct SparseWord
{
    std::size_t index = 0;
    std::uint64_t bits = 0;
};

std::vector<SparseWord> sparse(const std::vector<std::uint64_t>& words)
{
    std::vector<SparseWord> kept;
    for (std::size_t i = 0; i < words.size(); ++i)
        if (words[i] != 0)
            kept.push_back({i, words[i]});
    return kept;
}

/// Inserts the cells of a list, of which neighbours most often share a bit; returns their number.
std::size_t insertNear(std::vector<std::uint64_t>& near, std::span<const std::int32_t> cells)
{
    std::size_t last = std::numeric_limits<std::size_t>::max();
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (cells[i] == SkinBand::kNone)
            return i;
        const std::size_t bit = static_cast<std::size_t>(cells[i]) / kCellsPerBit;
        if (bit != last)
            insertBit(near, bit);
        last = bit;
    }
    return cells.size();
}

} // namespace

void PassedCells::startOver(std::size_t strands, int nodes)
{
    m_most = Lay::mostPassed(nodes);
    m_chunks.assign((strands + kChunkSlots - 1) / kChunkSlots, Chunk());
}

void PassedCells::startChunk(std::size_t chunk)
{
    std::ranges::fill(m_chunks[chunk].near, 0);
    m_chunks[chunk].puts = 0;
}

void PassedCells::put(std::size_t strand, std::span<const std::int32_t> cells)
{
    Chunk& chunk = m_chunks[chunkOf(strand)];
    const bool none = cells.empty() || cells.front() == SkinBand::kNone;
    if (chunk.lists.empty()) {
        if (none)
            return;
        chunk.lists.assign(kChunkSlots * m_most, SkinBand::kNone);
    }
    const auto list = chunk.lists.begin() + static_cast<std::ptrdiff_t>(inChunk(strand) * m_most);
    *list = SkinBand::kNone;
    if (none)
        return;
    const std::size_t count = insertNear(chunk.near, cells);
    std::copy_n(cells.begin(), count, list);
    if (count < m_most)
        list[static_cast<std::ptrdiff_t>(count)] = SkinBand::kNone;
    // Cells of earlier lists stay in the summary until as many lists were put as renewing it reads.
    if (++chunk.puts > 2 * kChunkSlots)
        renew(chunk);
}

void PassedCells::renew(Chunk& chunk) const
{
    std::ranges::fill(chunk.near, 0);
    for (std::size_t local = 0; local < kChunkSlots; ++local)
        insertNear(chunk.near, listOf(chunk, local));
    chunk.puts = 0;
}

void PassedCells::findPassing(std::span<const std::uint32_t> cells, std::size_t cellCount, SlotSet& strands) const
{
    if (cells.empty())
        return;
    // A byte for every cell, and before them one for SkinBand::kNone: for each cell of a list one load tells whether to
    // go on.
    enum Meaning : std::uint8_t
    {
        GoOn,
        Passes,
        Ends
    };
    std::vector<std::uint8_t> meanings(cellCount + 1, GoOn);
    const auto meaningOf = [&](std::int32_t cell) -> std::uint8_t& {
        return meanings[static_cast<std::size_t>(cell - SkinBand::kNone)];
    };
    meaningOf(SkinBand::kNone) = Ends;
    std::vector<std::uint64_t> around;
    for (const std::uint32_t cell : cells) {
        meaningOf(static_cast<std::int32_t>(cell)) = Passes;
        insertBit(around, cell / kCellsPerBit);
    }
    const std::vector<SparseWord> near = sparse(around);
    const auto passes = [&](std::span<const std::int32_t> list) {
        for (const std::int32_t cell : list)
            if (const std::uint8_t meaning = meaningOf(cell); meaning != GoOn)
                return meaning == Passes;
        return false;
    };
    const auto cameNear = [&](const Chunk& chunk) {
        return std::ranges::any_of(near, [&](const SparseWord& word) {
            return word.index < chunk.near.size() && (chunk.near[word.index] & word.bits) != 0;
        });
    };
    parallelFor(m_chunks.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t index = begin; index < end; ++index) {
            const Chunk& chunk = m_chunks[index];
            if (!cameNear(chunk))
                continue;
            for (std::size_t local = 0; local < kChunkSlots; ++local)
                if (passes(listOf(chunk, local)))
                    strands.insert(static_cast<std::uint32_t>(index * kChunkSlots + local));
        }
    });
}

} // namespace hairpaint::sim
