// The rest shape of a hair that stands upright.
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

} // namespace hairpaint::sim
