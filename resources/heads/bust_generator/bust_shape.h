// The bust-2 as a signed distance: a calm adult head with closed eyes on a display bust, from analytic primitives.
//
// Metres, y up, face toward +z, origin at the head's centre; symmetric in x. Pure functions, any thread.
#pragma once

#include <glm/glm.hpp>

namespace hairpaint::heads {

struct ShapeOptions
{
    // 0: no ear; to 0.5: a solid block slides out of the skull; to 1: the block turns into the ear. The mesh follows
    // this path, because a thin ear that grows at once collapses the mesh around it.
    float earGrowth = 1.0F;
};

// The bust ends at this height; the mesh's rim lies in the plane.
inline constexpr float baseHeight = -0.312F;

float bustDistance(const glm::vec3& p, const ShapeOptions& options);

// Central difference over a tetrahedron of the given size. Not normalised.
glm::vec3 bustGradient(const glm::vec3& p, const ShapeOptions& options, float step);

// A point that may lie on either side, as the parts see it.
struct MirroredPoint
{
    glm::vec3 plain;
    glm::vec3 folded; // x >= 0, with a kink at the middle: for parts that stay away from it
    glm::vec3 soft;   // x folded without a kink: for pairs that meet in the middle
};
MirroredPoint mirrored(const glm::vec3& p);

// The parts: each joins itself to the distance so far and returns the new one.
float joinFace(float distance, const MirroredPoint& p); // bones and flesh: jaw, cheeks, brow, sockets
float joinEyes(float distance, const MirroredPoint& p); // closed lids
float joinNose(float distance, const MirroredPoint& p);
float joinMouth(float distance, const MirroredPoint& p); // lips, philtrum
float joinEar(float distance, const MirroredPoint& p, float growth);
float joinNeck(float distance, const MirroredPoint& p);
float joinTrunk(float distance, const MirroredPoint& p); // shoulders and chest, cut for display

// Which part of the skin is it, 0 to 1: soft at the borders.
float lipsFraction(const MirroredPoint& p);
float lidsFraction(const MirroredPoint& p); // Both lids as far as the crease above, densest at the lashes.

} // namespace hairpaint::heads
