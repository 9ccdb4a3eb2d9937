// A strand as a flat ribbon that faces away from the head.
#pragma once

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace hairpaint::model {

/// Across and out of the ribbon at one of its points; both unit and at right angles to the strand.
struct RibbonFrame
{
    glm::vec3 side{1.0F, 0.0F, 0.0F};
    glm::vec3 normal{0.0F, 0.0F, 1.0F};
};

/// One a point. `middle`: what the ribbon faces away from, wherever it runs along it; elsewhere its frame goes on as it
/// was. The ribbon never flips from one point to the next.
void ribbonFrames(std::span<const glm::vec3> points, const glm::vec3& middle, std::vector<RibbonFrame>& frames);

} // namespace hairpaint::model
