// The table of kinds of worn things, as worn.h gives it to others.
#pragma once

#include "model/project/worn.h"

#include <span>

namespace hairpaint::model {

[[nodiscard]] std::span<const WornSpec> tableOfWornKinds(); ///< In the order of WornKind.

} // namespace hairpaint::model
