// The values of a map that are offered to be picked.
#pragma once

#include "model/project/map_spec.h"

#include <vector>

namespace hairpaint::view {

/// Round numbers of a scalar map's own unit, from its least value to its greatest; some seven, or those that the map
/// itself offers.
[[nodiscard]] std::vector<double> roundSteps(const sim::GroupSettings& settings, model::MapKind map);

} // namespace hairpaint::view
