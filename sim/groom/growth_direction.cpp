// What is painted or natural, and where long hair falls that nobody has combed.
#include "sim/groom/growth_direction.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::sim {

namespace {

constexpr float kShortFallM = 0.08F;   ///< Shorter hair lies as it grows.
constexpr float kLeastFlatness = 0.5F; ///< Least flatness of short hair that nobody has combed.
constexpr float kLongFallM = 0.20F;    ///< Longer hair lies as it falls, to its side.

/// How long hair that nobody has combed falls: to its own side of the middle and a little back from the face.
glm::vec3 fallDirection(glm::vec3 positionHd, glm::vec3 normal)
{
    constexpr float kSideways = 2.4F; // Against 1 for down, on top and at the forehead.
    constexpr float kBackward = 1.1F;
    constexpr float kMiddleM = 0.004F; // Half the width of the middle, where both sides meet.
    constexpr float kFlatness = 0.977F;
    const float front = std::clamp(normal.z, 0.0F, 1.0F);
    const float combing = std::max(std::clamp(normal.y, 0.0F, 1.0F), front);
    const float side = std::clamp(positionHd.x / kMiddleM, -1.0F, 1.0F);
    const glm::vec3 wanted(kSideways * combing * side, 0.9F * front - 1.0F, -kBackward * combing);
    const glm::vec3 along = wanted - normal * glm::dot(wanted, normal);
    const float square = glm::dot(along, along);
    return square > 1e-12F ? along * (kFlatness / std::sqrt(square)) : glm::vec3(kFlatness, 0.0F, 0.0F);
}

/// `grown`, made as long as `flatness` where it is shorter: hair at the middle of a whorl still leans to one side,
/// since a single upright hair would be an antenna. Where `grown` tells no side it leans to where long hair falls.
glm::vec3 atLeast(float flatness, glm::vec3 grown, glm::vec3 falls)
{
    constexpr float kTellsNoSide = 0.02F;
    const float length2 = glm::dot(grown, grown);
    if (length2 >= flatness * flatness)
        return grown;
    const glm::vec3 leaning = grown + falls * kTellsNoSide;
    return leaning * (flatness / std::max(std::sqrt(glm::dot(leaning, leaning)), 1e-6F));
}

} // namespace

glm::vec3 GrowthDirections::of(float falls) const
{
    // What turnedBetween() makes of two that are equal; adding 0 gives its zeros their sign.
    if (grownHd == fallenHd)
        return grownHd + glm::vec3(0.0F);
    return turnedBetween(grownHd, fallenHd, falls);
}

float fallFraction(float lengthM)
{
    const float t = std::clamp((lengthM - kShortFallM) / (kLongFallM - kShortFallM), 0.0F, 1.0F);
    return t * t * (3.0F - 2.0F * t);
}

float uncombed(DirectionVector painted, DirectionVector natural)
{
    constexpr float kCombed = 0.03F;
    return std::max(1.0F - glm::length(painted - natural) / kCombed, 0.0F);
}

GrowthDirections growthDirections(DirectionVector painted, const DirectionVector* natural, glm::vec3 positionHd,
                                  const SkinFrame& frame)
{
    const glm::vec3 grown = frame.toHd(painted);
    GrowthDirections directions{.grownHd = grown, .fallenHd = grown};
    if (natural == nullptr)
        return directions;
    const float own = uncombed(painted, *natural);
    if (own <= 0.0F)
        return directions;
    const glm::vec3 falls = fallDirection(positionHd, frame.normal);
    directions.grownHd = atLeast(kLeastFlatness * own, grown, falls);
    directions.fallenHd += (falls - grown) * own;
    return directions;
}

} // namespace hairpaint::sim
