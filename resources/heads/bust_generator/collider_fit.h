// Fits the ellipsoids that hair collides with to the skin.
//
// Levenberg-Marquardt on the signed distance of skin points to the ellipsoids' union; points that fit badly gain
// weight, so that the worst point counts and not the mean. The scalp weighs most, ears and base nothing.
#pragma once

#include <vector>

#include "bust_mesh.h"
#include "model/heads/built_in_heads.h"

namespace hairpaint::heads {

// Starts from the given ellipsoids. Those with a centre at x = 0 stay symmetric; the others come in pairs, each
// followed by its mirror image.
std::vector<sim::Ellipsoid> fittedColliders(const HalfMesh& half, std::span<const sim::Ellipsoid> start);

struct ColliderReport
{
    float scalpOutside; // m, how far the scalp's worst point lies outside the union
    float scalpInside;  // m, how far the union sticks out of the scalp at worst
    float elsewhere;    // m, the worst of the rest that was fitted
};

ColliderReport inspected(const HalfMesh& half, std::span<const sim::Ellipsoid> colliders);

} // namespace hairpaint::heads
