// Where the shape of a worn thing shows in the 3D area. Pure functions.
#pragma once

#include "model/project/worn.h"
#include "sim/skin/ellipsoid.h"
#include "sim/skin/skin.h"
#include "view/head_area/head_camera.h"

#include <optional>
#include <vector>

namespace hairpaint::view {

/// How the 3D area looks at the head.
struct HeadSight
{
    rendering::Camera camera;
    sim::HeadPose pose;
    QSizeF size; ///< px
};

/// Outlines of the sections through its centre across each of its own axes; without those that lie partly behind the
/// eye.
[[nodiscard]] std::vector<QPolygonF> outlinesOf(const sim::Ellipsoid& shape, const HeadSight& sight);
/// Number of the handle by which what stands on the skin is turned; it follows the ends of the axes.
inline constexpr int kTurnEnd = 6;
/// Position of that handle, Hd: off the thing, along its z axis.
[[nodiscard]] glm::vec3 turnEndHd(const model::Worn& worn);

/// An end of an axis that can be pulled, or what it is turned by.
struct WornHandle
{
    int end = 0; ///< Number of an axis's end, two for each axis in their order; or kTurnEnd.
    QPointF at;
};
/// The handles of a worn thing; without ends that are behind the eye, or in front of a drawn body, by which it is
/// moved.
[[nodiscard]] std::vector<WornHandle> handlesOf(const model::Worn& worn, const HeadSight& sight);
/// Direction from the centre to an axis's end, Hd, unit.
[[nodiscard]] glm::vec3 axisToEnd(const sim::Ellipsoid& shape, int end);
/// How far along the ray it meets a mesh of the unit ball's space, m; none where it misses it. `open`: from inside,
/// too.
[[nodiscard]] std::optional<float> meetingAlong(const sim::RayHd& ray, const sim::Ellipsoid& shape,
                                                const sim::HeadMesh& mesh, bool open);
/// How far along the ray it enters the shape, m; none where it misses it or begins inside.
[[nodiscard]] std::optional<float> entryAlong(const sim::RayHd& ray, const sim::Ellipsoid& shape);

} // namespace hairpaint::view
