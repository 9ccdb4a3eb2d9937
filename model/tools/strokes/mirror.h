// Where the reflected pointer lies in uv, and what is painted there.
#pragma once

#include "model/project/project.h"

#include <optional>

namespace hairpaint::model {

/// The uv on the other side of the head: u to 1 - u, to the bit, on built-in heads (and without a head); on others the
/// skin decides, and there is none off the islands or where the head has no other side.
[[nodiscard]] std::optional<glm::vec2> mirroredUv(const Head* head, glm::vec2 uv);

/// What `value` is on the other side of the point `at`: a vector reflected with the head, from one root's frame to the
/// other's; any other value itself. On built-in heads (and without a head) x changes its sign, to the bit.
[[nodiscard]] sim::Texel mirroredValue(const MapSpec& spec, const sim::Texel& value, const Head* head,
                                       const std::optional<sim::SurfacePoint>& at);

} // namespace hairpaint::model
