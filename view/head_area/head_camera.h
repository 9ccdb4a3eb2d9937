// Moving the 3D area's camera, and rays through its pixels. Pure functions.
#pragma once

#include "sim/motion/neck_motion.h"
#include "sim/motion/strand_frame.h"
#include "sim/skin/skin.h"
#include "view/rendering/scene.h"

#include <QPointF>
#include <QPolygonF>
#include <QSizeF>

#include <optional>

namespace hairpaint::view {

struct RayWo
{
    glm::vec3 originWo{0.0F};
    glm::vec3 directionWo{0.0F, 0.0F, -1.0F}; ///< Unit.
};

/// `position` in pixels of a view of `size`.
[[nodiscard]] RayWo rayThrough(const rendering::Camera& camera, QPointF position, QSizeF size);
[[nodiscard]] sim::RayHd inHead(const RayWo& ray, const sim::HeadPose& pose);
[[nodiscard]] glm::vec3 inWorld(glm::vec3 positionHd, const sim::HeadPose& pose);
/// Where a point lies in the view; none behind the eye.
[[nodiscard]] std::optional<QPointF> project(const rendering::Camera& camera, glm::vec3 positionWo, QSizeF size);

/// `pixels` since the drag's start, where the camera was `start`.
[[nodiscard]] rendering::Camera orbited(const rendering::Camera& start, QPointF pixels);
[[nodiscard]] rendering::Camera panned(const rendering::Camera& start, QPointF pixels, QSizeF size);
/// Factor above 1 comes nearer; what lies under `position` at the target's depth stays there.
[[nodiscard]] rendering::Camera zoomed(const rendering::Camera& camera, double factor, QPointF position, QSizeF size);
/// Turned so that skin with that normal faces the eye; moved there too where the point would not be seen.
[[nodiscard]] rendering::Camera lookingAt(const rendering::Camera& camera, glm::vec3 positionWo, glm::vec3 normalWo);
/// Whether the head hides a point of its skin from the camera.
[[nodiscard]] bool hidden(const sim::SurfacePoint& point, const sim::Skin* skin, const rendering::Camera& camera,
                          const sim::HeadPose& pose);
/// A ring around a point of the skin, in px; empty where a part lies behind the eye.
[[nodiscard]] QPolygonF ringSeen(const sim::SurfacePoint& point, float radiusM, const rendering::Camera& camera,
                                 const sim::HeadPose& pose, QSizeF size);
/// Between two cameras, by the smaller angle; t 0..1.
[[nodiscard]] rendering::Camera between(const rendering::Camera& from, const rendering::Camera& to, float t);

/// The head turned on its neck by a drag, as far as it goes: what the camera sees of it follows the pointer.
[[nodiscard]] sim::NeckAngles turned(const sim::NeckAngles& start, const sim::Neck& neck,
                                     const rendering::Camera& camera, QPointF pixels);

} // namespace hairpaint::view
