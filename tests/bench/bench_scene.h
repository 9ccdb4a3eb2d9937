// A ball of a head with painted maps, for benchmarks of groom and simulation.
#pragma once

#include "sim/groom/groom_input.h"

namespace hairpaint::bench {

/// `hairs` candidates, all of them hairs; every one is a basis hair where `allBasis`. Maps of 1024, wind and ellipsoids
/// as a project has them; nothing is built yet.
[[nodiscard]] sim::GroomInput sceneOf(int hairs, int nodes, bool allBasis);

/// The input after a dab on its length map that covers one per cent of the head.
[[nodiscard]] sim::GroomInput dabbed(const sim::GroomInput& before, int number);

/// The same on its direction map.
[[nodiscard]] sim::GroomInput combed(const sim::GroomInput& before, int number);

} // namespace hairpaint::bench
