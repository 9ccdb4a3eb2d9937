// Brings two heads together by their landmarks.
#pragma once

#include "sim/skin/head_landmarks.h"

#include <glm/glm.hpp>

#include <array>

namespace hairpaint::sim {

/// Maps positions on one head to the corresponding positions on another: landmarks to landmarks exactly, what lies
/// between and around them with the least bending. Immutable; any thread. Hd, m. Source: the thin plate spline of
/// Bookstein, Principal Warps (1989), whose kernel in space is the distance itself. Landmarks that lie in one plane or
/// coincide give the smallest warp that brings them together as far as can be.
class HeadWarp
{
public:
    HeadWarp(const HeadLandmarks& from, const HeadLandmarks& to);
    [[nodiscard]] glm::vec3 operator()(const glm::vec3& positionHd) const;

private:
    static constexpr std::size_t kAffineTerms = 4; ///< 1, x, y, z

    std::array<glm::dvec3, kHeadLandmarkCount> m_centres;
    std::array<glm::dvec3, kHeadLandmarkCount + kAffineTerms> m_weights;
};

} // namespace hairpaint::sim
