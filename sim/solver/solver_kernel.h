// The solver's inner loop: many strands, one lane each, some steps.
#pragma once

#include "sim/solver/solver_layout.h"

#include <cstddef>
#include <span>

namespace hairpaint::sim {

/// Takes blocks begin..end through `steps`. The first step reads positions[from] and writes positions[1 - from], the
/// next in reverse. Blocks do not depend on each other: any division into ranges gives the same bytes, and so does
/// every instruction set. Neither allocates nor throws.
void stepBlocks(const SolverBlocks& blocks, const GroupGains& gains, const ColliderSet& colliders,
                std::span<const StepForces> steps, int from, std::size_t begin, std::size_t end);

} // namespace hairpaint::sim
