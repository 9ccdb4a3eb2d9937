// The drawn curve of one strand along its skeleton: equation 1 (curl) and equation 3 (braid).
#pragma once

#include "sim/groom/groom.h"

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace hairpaint::sim {

/// Equation 1 without its linear part: (cos t, sin t, cos t sin t), in units of the radius.
[[nodiscard]] glm::vec3 curlOffset(float t);
/// Equation 3 without its linear part, for wisp offset w: (cos(t + w), 0, sin(2(t + w))), in units of r.
[[nodiscard]] glm::vec3 braidOffset(float t, float w);

/// Fraction of the strand, from the root, over which the curl's radius grows from 0.
inline constexpr float kCurlEaseFraction = 0.25F;
/// Part of a turn of the braid over which its wisps part where it begins, and the fraction of r that they begin with:
/// they come to it over the span before, since so many hairs never pass through one point.
inline constexpr float kBraidEaseTurns = 0.5F;
inline constexpr float kBraidFirstFraction = 0.25F;
inline constexpr float kWispRadiusFraction =
    0.9F; ///< A wisp's radius in units of r: wisps touch where the plait bends too.
/// The wisps of a twist run round its middle at this distance and have this radius, in units of r; a loc is one wisp.
inline constexpr float kTwistFraction = 0.6F;
inline constexpr float kTwistWispFraction = 0.65F;
inline constexpr float kLocWispFraction = 0.9F;
/// A wisp's greatest radius along the braid, in turns of it, so that three, or two, of them fill a turn.
inline constexpr float kPlaitRoomTurns = 0.2F;
inline constexpr float kTwistRoomTurns = 0.3F;
/// Last fraction of the braid, a tuft like a paint brush: its wisps become one and open to kTuftWispFraction of their
/// radius, and the hairs of a wisp's rim end kTuftUneven of it before the end, those of its middle there.
inline constexpr float kTuftFraction = 0.12F;
inline constexpr float kTuftWispFraction = 1.5F;
inline constexpr float kTuftUneven = 0.5F;
/// Fraction of the braid before the tuft where it is drawn together as by a tie: there the wisps close up to
/// kTieBraidFraction of r, and each to kTieWispFraction of its radius.
inline constexpr float kTieFraction = 0.05F;
inline constexpr float kTieBraidFraction = 0.25F;
inline constexpr float kTieWispFraction = 0.6F;

/// Segments that a style's curl and braid ask for: at least 8 points a turn; 0..256, 0 for a straight hair.
[[nodiscard]] int curveSegmentsOf(const StrandStyle& style);
/// The same, and at least two a skeleton's segment.
[[nodiscard]] int segmentsOf(const StrandStyle& style, int nodes);

/// The tangent that a hair's frame starts from: its root's, or for a braided hair that of its braid's centre, so that
/// all hairs of a braid are turned alike.
[[nodiscard]] glm::vec3 frameTangentHd(const Groom& groom, std::uint32_t slot);

/// Evaluates segments + 1 points, root first, along the skeleton (Catmull-Rom through `skeletonHd`, evenly by node).
/// `rootTangentHd`: frameTangentHd, turned as the head is. A curl stands in the skeleton's rotation-minimising frame,
/// which starts from that tangent (double reflection, Wang et al. 2008). A braid's hairs reach it from all sides: over
/// the first span of it their frame has that tangent's own projection as its first axis, and from the node after, which
/// they share, it too minimises rotation, so that a braid that bends does not come apart. The shader strand_expand.comp
/// does the same.
void evaluateStrand(std::span<const glm::vec3> skeletonHd, glm::vec3 rootTangentHd, const StrandStyle& style,
                    int segments, std::vector<glm::vec3>& pointsHd);

} // namespace hairpaint::sim
