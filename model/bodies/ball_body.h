// A ball.
#pragma once

#include "sim/skin/head_mesh.h"

#include <memory>

namespace hairpaint::model {

/// The unit ball, made once.
[[nodiscard]] std::shared_ptr<const sim::HeadMesh> ballBody();

} // namespace hairpaint::model
