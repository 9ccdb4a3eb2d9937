// The drawn curve of one strand along its skeleton: equation 1 (curl) and equation 3 (braid).
#pragma once

#include "sim/groom/curve_constants.h"
#include "sim/groom/groom.h"

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace hairpaint::sim {

/// Equation 1 without its linear part: (cos t, sin t, cos t sin t), in units of the radius.
[[nodiscard]] glm::vec3 curlOffset(float t);
/// What a coil in real units adds to a fraction s of a hair, m: along its frame's first axis and second.
[[nodiscard]] glm::vec3 coilOffset(const StrandStyle& style, const CurlSettings& curl, float s);
/// Equation 3 without its linear part, for wisp offset w: (cos(t + w), 0, sin(2(t + w))), in units of r.
[[nodiscard]] glm::vec3 braidOffset(float t, float w);

/// How the wisps of a kind of braid run, in units of r.
struct BraidLacing
{
    int wisps = 1;
    float swings = 2.0F;  ///< Through the braid's thickness, for one across its width.
    glm::vec2 path{0.0F}; ///< How far from the middle: across its width, through its thickness.
    float wisp = 1.0F;    ///< Radius of a wisp.
};
[[nodiscard]] BraidLacing lacingOf(BraidKind kind);

/// How far a style's frizz strays at its tip, and its waves over the whole hair, rad.
struct FrizzOfStyle
{
    float radiusM = 0.0F;
    float waveRad = 0.0F;
};
[[nodiscard]] FrizzOfStyle frizzOf(const StrandStyle& style);

/// Segments that a style's curl, braid and frizz ask for: at least 8 points a turn; 0..256, with coils 0..1024, 0 for a
/// straight hair.
[[nodiscard]] int curveSegmentsOf(const StrandStyle& style, const CurlSettings* coils = nullptr);
/// The same, and at least two a skeleton's segment.
[[nodiscard]] int segmentsOf(const StrandStyle& style, int nodes, const CurlSettings* coils = nullptr);

/// The curl's numbers where it is measured in real units, else null.
[[nodiscard]] inline const CurlSettings* coilsOf(const GroupSettings& settings)
{
    return settings.turnsMode == TurnsMode::Coils ? &settings.curl : nullptr;
}

/// The tangent that a hair's frame starts from: its root's, with Coils what lies beside the hair on the skin, or for a
/// braided hair that of its braid's centre, so that all hairs of a braid are turned alike.
[[nodiscard]] glm::vec3 frameTangentHd(const Groom& groom, std::uint32_t slot);

/// Evaluates segments + 1 points, root first, along the skeleton (Catmull-Rom through `skeletonHd`, evenly by node).
/// `rootTangentHd`: frameTangentHd, turned as the head is. A curl stands in the skeleton's rotation-minimising frame,
/// which starts from that tangent (double reflection, Wang et al. 2008). A braid's hairs reach it from all sides: over
/// the first span of it their frame has that tangent's own projection as its first axis, and from the node after, which
/// they share, it too minimises rotation, so that a braid that bends does not come apart. The formula is
/// curve_formula.inl.
/// `coils`: see coilsOf(); where null curls are equation 1's.
void evaluateStrand(std::span<const glm::vec3> skeletonHd, glm::vec3 rootTangentHd, const StrandStyle& style,
                    int segments, std::vector<glm::vec3>& pointsHd, const CurlSettings* coils = nullptr);

} // namespace hairpaint::sim
