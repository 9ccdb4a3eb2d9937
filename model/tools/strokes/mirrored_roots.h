// Which hair grows where another one would, were the head reflected over its middle.
#pragma once

#include "sim/motion/strand_frame.h"

#include <cstdint>
#include <vector>

namespace hairpaint::model {

inline constexpr std::uint32_t kNoMirroredRoot = 0xFFFFFFFFU;

/// By slot: of the positioned hairs the one whose root is nearest to this one's reflection; none within 5 mm (more
/// where hair is sparse), or of a slot whose hair is not positioned: kNoMirroredRoot. 40 ms for 100,000 hairs; uses
/// parallelFor.
[[nodiscard]] std::vector<std::uint32_t> mirroredRoots(const sim::GroupFrame& hair);

} // namespace hairpaint::model
