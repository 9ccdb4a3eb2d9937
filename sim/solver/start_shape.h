// How a strand leaves the skin, and how it hangs before the solver has seen it.
#pragma once

#include "sim/solver/collider_set.h"

#include <glm/glm.hpp>

#include <span>

namespace hairpaint::sim {

struct StrandRoot
{
    glm::vec3 positionHd{0.0F};
    glm::vec3 normalHd{0.0F, 1.0F, 0.0F};
    float lengthM = 0.0F;
    float gel = 0.0F;       ///< 0..1
    float body = 0.0F;      ///< 0..1
    float parting = 0.6F;   ///< 0..1
    float sweepBack = 0.3F; ///< 0..1
    float hash01 = 0.0F;    ///< The strand's own number, 0..1.
};

/// The unit direction in which a strand leaves the skin. Short, gelled or full-bodied hair stands along the normal;
/// long loose hair lies along the head, combed to its side of the middle and back from the face. Hd.
[[nodiscard]] glm::vec3 lieDirection(const StrandRoot& root);

/// A strand that leaves in direction `lie`, bends toward `downHd` and lies on the ellipsoids (scaled by `scales`), into
/// `nodesHd`, root first; `styled` 0..1 mixes in the rest shape. Segments are `segmentM` long. The solver settles it.
void hangStrand(std::span<glm::vec3> nodesHd, std::span<const glm::vec3> restHd, glm::vec3 lie, glm::vec3 downHd,
                float segmentM, float styled, const ColliderSet& colliders, std::span<const float> scales);

} // namespace hairpaint::sim
