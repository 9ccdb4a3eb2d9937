// Which hairs make a lock: the scalp divided among some of the basis hairs, each of which leads its lock.
#pragma once

#include "sim/groom/roots.h"

#include <cstdint>
#include <vector>

namespace hairpaint::sim {

class LockPartition
{
public:
    /// Each basis hair leads a lock of its own.
    LockPartition() = default;
    /// Locks `sizeM` apart, led by the first of the ranks, which cover the skin evenly. Where the basis hairs are no
    /// closer, or at 0, it is as the default.
    LockPartition(const RootSet& roots, float sizeM);

    [[nodiscard]] bool isOfBasis() const { return m_leaderOfBasis.empty(); }
    /// Index of a basis hair: the nearest leader of those near the root; `ragged` 0..1 gives hairs at the edge to the
    /// next lock by chance. A leader leads itself.
    [[nodiscard]] std::uint32_t leaderOf(const RootSet& roots, std::uint32_t slot, float ragged) const;

private:
    std::vector<std::uint32_t> m_leaderOfBasis; ///< [basis hairs]
};

} // namespace hairpaint::sim
