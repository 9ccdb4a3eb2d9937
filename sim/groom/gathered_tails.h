// The hair behind rings as a groom of its own.
#pragma once

#include "sim/groom/groom.h"

#include <memory>

namespace hairpaint::sim {

/// Strands that begin in the ring, in the slots of the gathered hairs that hang there; `basis` are their solved hairs.
/// Those of chunks that are what they were in `before` (may be null) are kept, and all of them where none differs.
/// Null where nothing hangs. Uses parallelFor.
[[nodiscard]] std::shared_ptr<const Groom> tailsOf(const Groom& groom, const std::shared_ptr<const BasisStyles>& basis,
                                                   const Groom* before);

} // namespace hairpaint::sim
