// A strand's shape in the terms of a groom: its length, its coil, and the line that it coils around.
#pragma once

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace hairpaint::model {

struct StrandShape
{
    float lengthM = 0.0F; ///< Length of the line that the strand coils around, m.
    float turns = 0.0F;   ///< Turns of the coil over the whole strand; 0 where the strand is straight or merely bent.
    float radiusM = 0.0F; ///< Full radius of the coil, m.
    /// Unit direction from the line to the strand, a little beyond the middle; zero without a coil.
    glm::vec3 asideHd{0.0F};
};

/// Buffers of measureStrand(), kept from one strand to the next. One per thread.
struct StrandScratch
{
    std::vector<float> alongM;     ///< By point: its distance from the root along the strand, m.
    std::vector<glm::vec3> evenHd; ///< The strand resampled at even distances.
    std::vector<glm::dvec3> sums;  ///< Prefix sums of evenHd.
    std::vector<glm::vec3> axisHd; ///< Out: the line without the coil, root first; at least two points.
};

/// A strand of at least two points, Hd. Coils of fewer than about one turn count as bends. Writes scratch.axisHd.
[[nodiscard]] StrandShape measureStrand(std::span<const glm::vec3> pointsHd, StrandScratch& scratch);

} // namespace hairpaint::model
