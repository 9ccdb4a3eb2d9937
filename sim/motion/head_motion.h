// The head's pose from step to step, and the hair's inertia against it.
#pragma once

#include "sim/motion/strand_frame.h"
#include "sim/skin/neck.h"
#include "sim/solver/solver_layout.h"

namespace hairpaint::sim {

/// Between two poses: `fraction` 0 is the first, 1 the second. Normalised linear: no transcendental function.
[[nodiscard]] HeadPose mixPoses(const HeadPose& from, const HeadPose& to, float fraction);

/// Where a point at rest in the world goes in the head's own frame, when the head moves. A head that is carried off
/// faster than hair can follow (18 m/s or 30 rad/s) takes its hair along: no motion.
[[nodiscard]] RigidMotion inertialMotion(const HeadPose& from, const HeadPose& to);

/// The same for the shoulders, that do not turn with the head; none where the neck has none.
[[nodiscard]] NeckTurn neckTurn(const Neck& neck, const HeadPose& pose);

/// From the head's frame to the world.
[[nodiscard]] RigidMotion worldOfHead(const HeadPose& pose);

[[nodiscard]] glm::vec3 directionToHead(const HeadPose& pose, glm::vec3 directionWo);
[[nodiscard]] glm::vec3 pointToHead(const HeadPose& pose, glm::vec3 pointWo);

/// With a unit rotation; the fallback where a number is not finite.
[[nodiscard]] HeadPose sanePose(const HeadPose& pose, const HeadPose& fallback);

} // namespace hairpaint::sim
