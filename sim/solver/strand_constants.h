// What the solver keeps about each strand and each group: gains, lie on the head, distance from the ellipsoids.
#pragma once

#include "sim/groom/groom.h"
#include "sim/solver/strand_state.h"

namespace hairpaint::sim {

/// A group's constants for a step; gains given for 1/60 s are rescaled: k' = 1 - (1 - k)^(dt/dt0).
[[nodiscard]] GroupGains gainsOf(const PhysicsSettings& physics, int nodes);

/// The basis hair's rank where the groom has roots, its index elsewhere, as a number 0..1 that stays with the hair.
[[nodiscard]] float strandHash(const Groom& groom, std::size_t basisIndex);

/// Fills a basis hair's rows in `state`, except kStill.
void setStrandConstants(StrandState& state, const Groom& groom, std::size_t basisIndex, const ColliderSet& colliders);

/// A fibre's stiffness between nodes `segmentM` apart, in units of a step: g dt^2 stiffness^3 / segment^4, which is
/// E I dt^2 / (rho A segment^4).
[[nodiscard]] float bendingGain(float stiffnessM, float segmentM);

/// How strongly gel of 0..1 pulls every node to its position in the rest shape, in units of a step: displacements are
/// divided by 1 + this.
[[nodiscard]] float holdGain(float gel);
/// How far a strand that hangs is in its rest shape with such a gain: 0 not at all, 1 wholly.
[[nodiscard]] float styledFraction(float holdGain);
/// Strength at the root of the spring that PhysicsSettings::loft of 0..1 asks for, in units of a step; see kLoft.
[[nodiscard]] float loftGain(float loft);

/// Thickness that a strand's height in the coat adds to the ellipsoids under it; never more than half a segment.
[[nodiscard]] float coatM(float height, float volumeM, float segmentM);

} // namespace hairpaint::sim
