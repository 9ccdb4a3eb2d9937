// How coiled hair hangs together in locks.
#pragma once

#include "model/importing/head_strands.h"

#include <span>

namespace hairpaint::model {

struct LockEstimate
{
    float clump = 0.0F; ///< As the clump map has it; 0 where no locks are to be seen.
    float hairs = 0.0F; ///< Number of hairs in a lock.
};

/// From how far the coils of neighbours are in phase. About 50 ms.
[[nodiscard]] LockEstimate estimateLocks(std::span<const HeadStrand> strands);

} // namespace hairpaint::model
