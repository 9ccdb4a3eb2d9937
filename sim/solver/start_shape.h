// How a strand hangs before the solver has seen it.
#pragma once

#include "sim/solver/collider_set.h"

#include <glm/glm.hpp>

#include <span>

namespace hairpaint::sim {

/// What bends a strand from its rest shape.
struct HangingStrand
{
    float segmentM = 0.0F;
    float stiffnessM = 0.05F; ///< See PhysicsSettings.
    float girthM = 0.0F;      ///< How far it is kept from the skin, see kGirth,
    float firstGirthM = 0.0F; ///< and its first node.
    float styled = 0.0F;      ///< 0..1: how far the rest shape is held.
    glm::vec3 downHd{0.0F, -1.0F, 0.0F};
};

/// Leaves the root as `restHd` does, bends toward down past the length that it carries by itself, and lies on skin and
/// ellipsoids (scaled by `scales`), into `nodesHd`, root first. The solver settles it.
void hangStrand(std::span<glm::vec3> nodesHd, std::span<const glm::vec3> restHd, const HangingStrand& strand,
                const ColliderSet& colliders, std::span<const float> scales);

} // namespace hairpaint::sim
