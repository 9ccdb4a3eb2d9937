// The drawn curve of one strand along its skeleton: equation 1 (curl) and equation 3 (braid).
#pragma once

#include "sim/groom.h"

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace hairpaint::sim {

/// Equation 1 without its linear part: (cos t, sin t, cos t sin t), in units of the radius.
[[nodiscard]] glm::vec3 curlOffset(float t);
/// Equation 3 without its linear part, for wisp offset w: (cos(t + w), 0, sin(2(t + w))), in units of r.
[[nodiscard]] glm::vec3 braidOffset(float t, float w);

/// Segments that a style asks for: at least 8 points a turn, `smooth` for a straight hair; at most 256.
[[nodiscard]] int segmentsOf(const StrandStyle& style, int nodes);

/// Evaluates segments + 1 points, root first, along the skeleton (Catmull-Rom through `skeletonHd`) in its
/// rotation-minimising frame (double reflection, Wang et al. 2008). `rootTangentHd` starts the frame. The shader
/// strand_expand.comp does the same. Radius eases in from 0 at the root.
void evaluateStrand(std::span<const glm::vec3> skeletonHd, glm::vec3 rootTangentHd, const StrandStyle& style,
                    int segments, std::vector<glm::vec3>& pointsHd);

} // namespace hairpaint::sim
