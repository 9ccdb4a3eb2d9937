// The hairs that passed where the field differs.
#include "sim/groom/lay_changes.h"

#include "sim/base/parallel.h"

#include <algorithm>

namespace hairpaint::sim {

namespace {

/// One bit a cell.
class CellSet
{
public:
    CellSet(std::size_t cells, std::span<const std::uint32_t> indices) : m_words(cells / 64 + 1, 0)
    {
        for (const std::uint32_t index : indices)
            m_words[index / 64] |= std::uint64_t{1} << (index % 64);
    }

    /// `passed`: up to the first kNone.
    [[nodiscard]] bool anyOf(std::span<const std::int32_t> passed) const
    {
        for (const std::int32_t cell : passed) {
            if (cell == SkinBand::kNone)
                return false;
            const auto index = static_cast<std::size_t>(cell);
            if (((m_words[index / 64] >> (index % 64)) & 1U) != 0)
                return true;
        }
        return false;
    }

private:
    std::vector<std::uint64_t> m_words;
};

} // namespace

void findRelaid(const Groom& before, std::span<const std::int32_t> passedByBasis, std::size_t cellCount,
                const LayField::Difference& difference, ChangedSlots& changed)
{
    if (difference.indices.empty())
        return;
    const CellSet differ(cellCount, difference.indices);
    const std::size_t most = Lay::mostPassed(before.nodes);
    const RootSet& roots = *before.roots;
    parallelFor(before.chunks.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t index = begin; index < end; ++index) {
            const StrandChunk* chunk = before.chunks[index].get();
            if (chunk == nullptr)
                continue;
            for (std::size_t local = 0; local < kChunkSlots; ++local)
                if (chunk->hairs[local] && differ.anyOf(std::span(chunk->passed).subspan(local * most, most)))
                    changed.hairs.insert(static_cast<std::uint32_t>(index * kChunkSlots + local));
        }
    });
    for (std::size_t i = 0; i < roots.basisSlot.size(); ++i)
        if (differ.anyOf(passedByBasis.subspan(i * most, most)))
            changed.basis.insert(roots.basisSlot[i]);
}

} // namespace hairpaint::sim
