// Which basis hairs a hair follows, and how much.
#pragma once

#include "sim/groom/roots.h"

namespace hairpaint::sim {

/// Fills `neighbours` and `weights` of a set whose other arrays are complete. O(n log b); uses parallelFor.
void findBasisNeighbours(RootSet& roots);

} // namespace hairpaint::sim
