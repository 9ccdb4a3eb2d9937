// Which hairs lie otherwise after a change of the direction map.
#pragma once

#include "sim/groom/groom.h"
#include "sim/groom/lay.h"
#include "sim/groom/map_changes.h"

#include <span>

namespace hairpaint::sim {

/// What hairs lay by before.
struct LaidBefore
{
    const Groom& groom;
    const MapSampler& clump;
    const Lay& lay;
    std::span<const float> basisLengthM; ///< [basis hairs]
};

/// Adds the hairs, and basis hairs, whose way crosses a cell that differs: exactly those, found by following the old
/// map, beside those at whose own roots it differs (MapChanges). `field` as it was. Uses parallelFor.
void findRelaid(const LaidBefore& before, const LayField& field, const LayField::Difference& difference,
                ChangedSlots& changed);

} // namespace hairpaint::sim
