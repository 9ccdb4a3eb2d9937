// Closed meshes of which worn things are made: sections drawn along a line.
#pragma once

#include "sim/skin/head_mesh.h"

#include <span>
#include <vector>

namespace hairpaint::model {

/// An ellipse across the line that is swept.
struct SweptSection
{
    glm::vec3 centre{0.0F};
    glm::vec3 side{1.0F, 0.0F, 0.0F}; ///< Unit, at right angles to `up`, which is unit, too.
    glm::vec3 up{0.0F, 1.0F, 0.0F};
    float halfSide = 0.1F; ///< Semi-axis along `side`, above 0.
    float halfUp = 0.1F;   ///< Semi-axis along `up`, above 0.
};

/// Adds the surface of what the sections sweep: a ring where `closed`, else with flat ends. `corners`: of a section.
void addSwept(sim::HeadMesh& mesh, std::span<const SweptSection> sections, bool closed, int corners);

/// A tube around the points of a line: round sections of those radii.
[[nodiscard]] std::vector<SweptSection> tubeAlong(std::span<const glm::vec3> line, std::span<const float> radii,
                                                  bool closed);
struct RibbonPoint
{
    glm::vec3 centre{0.0F};
    glm::vec3 across{1.0F, 0.0F, 0.0F}; ///< About the direction of its width.
    float halfWidth = 0.1F;
};
/// Adds a ribbon with flat ends along points.
void addRibbon(sim::HeadMesh& mesh, std::span<const RibbonPoint> points, float halfThickness, int corners);

/// In the space where `proportions` are the axes of a ball's radius, and there in the ball of `reach`.
void fitInBall(sim::HeadMesh& mesh, glm::vec3 proportions, float reach);

} // namespace hairpaint::model
