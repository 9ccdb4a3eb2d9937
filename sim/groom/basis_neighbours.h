// Which basis hairs a hair follows, and how much.
#pragma once

#include "sim/groom/roots.h"

namespace hairpaint::sim {

/// Fills `neighbours` and `weights` of a set whose other arrays are complete. O(n log b); uses parallelFor.
void findBasisNeighbours(RootSet& roots);

/// [basis hairs] for each the nearest basis hair among those with the first `leaderCount` ranks, as an index into
/// `basisSlot`; those themselves are their own.
[[nodiscard]] std::vector<std::uint32_t> nearestLeaders(const RootSet& roots, std::size_t leaderCount);

} // namespace hairpaint::sim
