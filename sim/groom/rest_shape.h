// Rest shapes: where a hair's nodes are without gravity.
#pragma once

#include <glm/glm.hpp>

#include <span>

namespace hairpaint::sim {

/// Where a hair stands.
struct RootFrame
{
    glm::vec3 positionHd;
    glm::vec3 normalHd; ///< Unit.
};

/// Straight along the normal, nodes evenly spaced.
void straightRest(const RootFrame& root, float lengthM, std::span<glm::vec3> nodesHd);

/// Draws the nodes toward a basis hair's, `basisHd`, at the same distance along the hair, by `clump` times a fraction
/// that grows to the tip, and restores the distance of neighbouring nodes. Beyond the end of a shorter basis hair they
/// are drawn as there. (Hernandez and Rudomin 2004, clumpiness.)
void clumpRest(std::span<const glm::vec3> basisHd, float basisSegmentM, float clump, float segmentM,
               std::span<glm::vec3> nodesHd);

} // namespace hairpaint::sim
