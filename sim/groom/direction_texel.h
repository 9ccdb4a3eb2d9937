// How the direction map stores its vectors.
#pragma once

#include "sim/base/tiled_raster.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace hairpaint::sim {

/// The direction in which hair leaves the skin, projected on the tangent plane, in the frame of the root (SkinFrame).
/// Its length is the cosine of the angle to the skin: 0 stands upright, 1 lies flat. Never longer than 1.
using DirectionVector = glm::vec2;

inline constexpr float kDirectionZero = 32768.0F; ///< What a channel stores for 0;
inline constexpr float kDirectionOne = 32767.0F;  ///< and how far from it for 1.

/// The same, scaled down where it is longer than 1.
[[nodiscard]] inline DirectionVector shortened(DirectionVector direction)
{
    const float square = glm::dot(direction, direction);
    return square > 1.0F ? direction / std::sqrt(square) : direction;
}

/// From the two channels, each 0..65535 and possibly between two steps.
[[nodiscard]] inline DirectionVector directionOfChannels(glm::vec2 channels)
{
    return shortened(glm::clamp((channels - kDirectionZero) / kDirectionOne, -1.0F, 1.0F));
}
[[nodiscard]] inline DirectionVector directionOf(const Texel& texel)
{
    return directionOfChannels({static_cast<float>(texel[0]), static_cast<float>(texel[1])});
}

/// Directions whose mean is shorter than this fraction of them are opposed and have no mean direction.
inline constexpr float kOpposedDirections = 0.02F;
/// Texels side by side that differ by more than 120 degrees are the two sides of a parting: halfway between them hair
/// would lie along it and fall over the face.
inline constexpr float kPartedDirections = 0.5F;

/// The mean of directions, made as long as the mean of their lengths. The mean alone would make hair stand where they
/// are opposed, as on both sides of a parting; there the result is the `nearest` of them. turned() of lay_kernel.cpp
/// computes the same.
template<typename Vector>
[[nodiscard]] Vector turned(const Vector& mean, float flatness, const Vector& nearest,
                            float opposed = kOpposedDirections)
{
    const float length = std::sqrt(glm::dot(mean, mean));
    return length > opposed * flatness ? mean * (flatness / length) : nearest;
}

/// Hair that turns from one direction to another, of which it has gone `fraction`, 0..1.
template<typename Vector>
[[nodiscard]] Vector turnedBetween(const Vector& from, const Vector& to, float fraction)
{
    const float flat = std::sqrt(glm::dot(from, from));
    const float flatness = flat + (std::sqrt(glm::dot(to, to)) - flat) * fraction;
    return turned(from + (to - from) * fraction, flatness, fraction < 0.5F ? from : to);
}

/// Samples a direction map between its texels.
[[nodiscard]] inline DirectionVector directionAt(const TiledRaster& map, glm::vec2 uv)
{
    const TiledRaster::Neighbours around = map.neighbours(uv);
    const Texel& first = around.texels[0];
    if (around.texels[1] == first && around.texels[2] == first && around.texels[3] == first)
        return directionOf(first);
    DirectionVector mean(0.0F);
    float flatness = 0.0F;
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < around.texels.size(); ++i) {
        const DirectionVector one = directionOf(around.texels[i]);
        mean += one * around.weights[i];
        flatness += std::sqrt(glm::dot(one, one)) * around.weights[i];
        nearest = around.weights[i] > around.weights[nearest] ? i : nearest;
    }
    return turned(mean, flatness, directionOf(around.texels[nearest]), kPartedDirections);
}

/// Rounds to the nearest step.
[[nodiscard]] inline Texel texelOfDirection(DirectionVector direction)
{
    const auto stored = [](float value) {
        return static_cast<std::uint16_t>(std::lround(std::clamp(value, -1.0F, 1.0F) * kDirectionOne + kDirectionZero));
    };
    const DirectionVector kept = shortened(direction);
    return {stored(kept.x), stored(kept.y), 0, 0};
}

} // namespace hairpaint::sim
