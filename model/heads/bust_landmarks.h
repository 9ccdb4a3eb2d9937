// Where things are on the built-in head bust-1: regions that grow hair, named points, and the ellipsoids hair collides
// with.
//
// Head space: metres, y up, face toward +z, origin at the head's centre. Everything is symmetric in x. Pure functions
// of constants: any thread, no errors.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <span>

namespace hairpaint::heads {

// Signed distance along the skin, in metres, from a point on it to a region's border; positive inside. True to a few
// percent near the border, a smooth field elsewhere. Points far off the skin get the value of the skin under them as
// seen from inside the head.
//
// scalp: forehead with slight recession at the temples, sideburn, round the ear, nape; ears are outside.
float scalpDistance(const glm::vec3& p);
// both eyebrows
float browDistance(const glm::vec3& p);
// cheeks below the sideburns, moustache, chin, under the jaw; lips are outside
float beardDistance(const glm::vec3& p);

struct BustLandmarks
{
    glm::vec3 crown;    // the mesh's pole, uv (0.5, 0.5)
    glm::vec3 forehead; // hairline's middle
    glm::vec3 earLeft;  // middle of the ear's opening; left is the head's own left, +x
    glm::vec3 earRight;
    glm::vec3 nape; // hairline's middle at the back
    glm::vec3 chin;
    glm::vec3 noseTip;
};

BustLandmarks bustLandmarks();

struct EllipsoidSpec
{
    glm::vec3 centre;   // m
    glm::vec3 semiAxes; // m, along the rotated x, y, z
    glm::quat rotation; // from the ellipsoid's axes to head space
};

// Cranium, face, jaw, neck, shoulders, chest: their union lies within about 2 mm of the scalp.
std::span<const EllipsoidSpec> bustColliders();

} // namespace hairpaint::heads
