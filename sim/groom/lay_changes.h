// Which hairs lie otherwise after a change of the direction map.
#pragma once

#include "sim/groom/groom.h"
#include "sim/groom/lay.h"
#include "sim/groom/map_changes.h"

#include <span>

namespace hairpaint::sim {

/// Adds the hairs, and basis hairs, whose lay passed a cell that differs, beside those at whose own roots the map does
/// (MapChanges). `passedByBasis`: [basis hairs][Lay::mostPassed]. Uses parallelFor.
void findRelaid(const Groom& before, std::span<const std::int32_t> passedByBasis, std::size_t cellCount,
                const LayField::Difference& difference, ChangedSlots& changed);

} // namespace hairpaint::sim
