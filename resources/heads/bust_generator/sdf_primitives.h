// Building blocks of the bust's signed distance: primitives, smooth unions, displacement profiles.
//
// Lengths in metres, distances negative inside. Round cones are exact; ellipsoids are first order, which is enough
// because every surface point is found by Newton steps.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace hairpaint::heads {

// The smaller of two distances, joined by a cubic blend (continuous curvature) where they differ by less than `width`.
inline float smoothMin(float a, float b, float width)
{
    const float overlap = std::max(width - std::abs(a - b), 0.0F) / width;
    return std::min(a, b) - overlap * overlap * overlap * width / 6.0F;
}

inline float smoothMax(float a, float b, float width)
{
    return -smoothMin(-a, -b, width);
}

inline float smoothStep(float from, float to, float x)
{
    const float t = std::clamp((x - from) / (to - from), 0.0F, 1.0F);
    return t * t * (3.0F - 2.0F * t);
}

// exp(-(x / width)^2), the profile of every groove and ridge.
inline float bell(float x, float width)
{
    const float t = x / width;
    return std::exp(-t * t);
}

inline float bell(const glm::vec3& p, const glm::vec3& centre, const glm::vec3& widths)
{
    const glm::vec3 t = (p - centre) / widths;
    return std::exp(-glm::dot(t, t));
}

inline float ellipsoid(const glm::vec3& p, const glm::vec3& centre, const glm::vec3& semiAxes)
{
    const glm::vec3 scaled = (p - centre) / semiAxes;
    const float radial = glm::length(scaled);
    const float slope = glm::length(scaled / semiAxes);
    return radial * (radial - 1.0F) / std::max(slope, 1.0e-6F);
}

// The hull of two spheres. The side's normal leans toward the smaller sphere, so the nearest sphere's centre on the
// axis lies x * tan(lean) behind the point's foot.
inline float roundCone(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b, float radiusA, float radiusB)
{
    const glm::vec3 axis = b - a;
    const float length = glm::length(axis);
    const glm::vec3 fromA = p - a;
    const float along = glm::dot(fromA, axis) / length;
    const float across = std::sqrt(std::max(glm::dot(fromA, fromA) - along * along, 0.0F));
    const float sine = (radiusA - radiusB) / length;
    const float tangent = sine / std::sqrt(std::max(1.0F - sine * sine, 1.0e-6F));
    const float foot = std::clamp(along - across * tangent, 0.0F, length);
    const float radius = radiusA + (radiusB - radiusA) * foot / length;
    return std::sqrt(across * across + (along - foot) * (along - foot)) - radius;
}

inline glm::vec3 turnedX(const glm::vec3& p, float degrees)
{
    const float c = std::cos(glm::radians(degrees));
    const float s = std::sin(glm::radians(degrees));
    return {p.x, c * p.y - s * p.z, s * p.y + c * p.z};
}

inline glm::vec3 turnedY(const glm::vec3& p, float degrees)
{
    const float c = std::cos(glm::radians(degrees));
    const float s = std::sin(glm::radians(degrees));
    return {c * p.x - s * p.z, p.y, s * p.x + c * p.z};
}

} // namespace hairpaint::heads
