// Leaders of locks, and who follows them.
#include "sim/groom/lock_partition.h"

#include "sim/base/deterministic.h"
#include "sim/groom/basis_neighbours.h"

#include <algorithm>

namespace hairpaint::sim {

namespace {

constexpr std::uint64_t kLockKey = 0x6C6F636B73U; ///< Apart from the keys of other uses of the seed.

} // namespace

LockPartition::LockPartition(const RootSet& roots, float sizeM)
{
    if (!(sizeM > 0.0F))
        return;
    const double count = roots.skin->areaM2() / (static_cast<double>(sizeM) * static_cast<double>(sizeM));
    if (count < static_cast<double>(roots.basisSlot.size()))
        m_leaderOfBasis = nearestLeaders(roots, static_cast<std::size_t>(std::max(count, 1.0)));
}

std::uint32_t LockPartition::leaderOf(const RootSet& roots, std::uint32_t slot, float ragged) const
{
    const std::array<std::uint32_t, RootSet::kNeighbours>& nearest = roots.neighbours[slot];
    if (isOfBasis())
        return nearest[0];
    const std::uint32_t own = m_leaderOfBasis[nearest[0]];
    if (roots.basisSlot[own] == slot)
        return own;
    std::uint32_t leader = own;
    float least = 0.0F;
    for (std::size_t k = 0; k < nearest.size(); ++k) {
        const std::uint32_t candidate = m_leaderOfBasis[nearest[k]];
        const glm::vec3 apart = roots.positionHd[roots.basisSlot[candidate]] - roots.positionHd[slot];
        float squared = glm::dot(apart, apart);
        if (candidate == own && ragged > 0.0F)
            squared *= 1.0F + ragged * unitFloat(hash64(roots.seed ^ kLockKey, roots.rankOfSlot[slot]));
        if (k == 0 || squared < least) {
            least = squared;
            leader = candidate;
        }
    }
    return leader;
}

} // namespace hairpaint::sim
