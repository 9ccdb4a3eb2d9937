// Where the reflected pointer lies in uv.
#pragma once

#include "model/project.h"

#include <optional>

namespace hairpaint::model {

/// The uv on the other side of the head: u to 1 - u, to the bit, on built-in heads (and without a head); on others the
/// skin decides, and there is none off the islands or where the head has no other side.
[[nodiscard]] std::optional<glm::vec2> mirroredUv(const Head* head, glm::vec2 uv);

} // namespace hairpaint::model
