// Which basis hairs a hair follows, and how much.
#pragma once

#include "sim/groom/roots.h"

namespace hairpaint::sim {

/// Fills `neighbours` and `weights` of a set whose other arrays are complete. O(n log b); uses parallelFor.
void findBasisNeighbours(RootSet& roots);

/// Of each basis hair the nearest of those with the first `leaderCount` ranks, as indices into `basisSlot`; of these it
/// is themselves. [basis hairs]
[[nodiscard]] std::vector<std::uint32_t> nearestLeaders(const RootSet& roots, std::size_t leaderCount);

} // namespace hairpaint::sim
