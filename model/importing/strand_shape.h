// A strand's shape in the terms of a groom: its length, its coil, and the line that it coils around.
#pragma once

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace hairpaint::model {

struct StrandShape
{
    float lengthM = 0.0F;    ///< Of the line without the coil.
    float turns = 0.0F;      ///< Of the coil over the whole strand; 0 where straight or merely bent.
    float radiusM = 0.0F;    ///< Of the coil where it is fully out.
    glm::vec3 asideHd{0.0F}; ///< From the line to the strand, a little beyond its middle; unit. Zero without a coil.
};

/// Kept from one strand to the next. One per thread.
struct StrandScratch
{
    std::vector<float> alongM;     ///< By point, from the root.
    std::vector<glm::vec3> evenHd; ///< The strand at even distances,
    std::vector<glm::dvec3> sums;  ///< and those added up.
    std::vector<glm::vec3> axisHd; ///< Out: the line without the coil, root first; at least two points.
};

/// A strand of at least two points, Hd. Coils of fewer than about one turn count as bends. Writes scratch.axisHd.
[[nodiscard]] StrandShape measureStrand(std::span<const glm::vec3> pointsHd, StrandScratch& scratch);

} // namespace hairpaint::model
