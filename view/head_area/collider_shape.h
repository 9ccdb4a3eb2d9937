// Where an ellipsoid that stands for the head shows in the 3D area. Pure functions.
#pragma once

#include "sim/skin/ellipsoid.h"
#include "view/head_area/head_camera.h"

#include <array>
#include <vector>

namespace hairpaint::view {

/// How the 3D area looks at the head.
struct HeadSight
{
    rendering::Camera camera;
    sim::HeadPose pose;
    QSizeF size; ///< px
};

inline constexpr int kColliderEnds = 6;

/// Where it is cut across each of its own axes through its centre; without those of which a part lies behind the eye.
[[nodiscard]] std::vector<QPolygonF> colliderOutlines(const sim::Ellipsoid& ellipsoid, const HeadSight& sight);
/// An end of one of its axes (two for each, in their order), Hd.
[[nodiscard]] glm::vec3 colliderEnd(const sim::Ellipsoid& ellipsoid, int end);
/// Unit, from the centre to that end, Hd.
[[nodiscard]] glm::vec3 colliderAxis(const sim::Ellipsoid& ellipsoid, int end);

} // namespace hairpaint::view
