// What hair is tied with. Each in a space in which hair leaves along z through a ring of an outer radius of about 1,
// made once; a ribbon's bow sits on the ring's +y.
#pragma once

#include "model/bodies/hanging_part.h"
#include "sim/skin/head_mesh.h"

#include <memory>
#include <span>

namespace hairpaint::model {

inline constexpr float kTieReach = 3.0F; ///< All of them lie within a ball of this radius.
inline constexpr float kTieHole = 0.62F; ///< Inner radius of each ring.

[[nodiscard]] std::shared_ptr<const sim::HeadMesh> elasticBody();
[[nodiscard]] std::shared_ptr<const sim::HeadMesh> ribbonTieBody();
[[nodiscard]] std::span<const HangingPart> ribbonTieTails(); ///< Of ribbonTieBody().
[[nodiscard]] std::shared_ptr<const sim::HeadMesh> cordBody();
[[nodiscard]] std::shared_ptr<const sim::HeadMesh> metalRingBody();

} // namespace hairpaint::model
