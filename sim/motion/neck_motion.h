// The head turned on its neck: how far it may be, how it comes back, and motions that it goes through by itself.
#pragma once

#include "sim/motion/strand_frame.h"
#include "sim/skin/head_landmarks.h"
#include "sim/skin/head_mesh.h"

#include <cstdint>
#include <optional>
#include <string_view>

namespace hairpaint::sim {

/// What the head turns about. Hd, which is Wo while the head looks straight ahead; m.
struct Neck
{
    glm::vec3 pivotHd{0.0F};
    glm::vec3 acrossHd{1.0F, 0.0F, 0.0F}; ///< Unit length, level, toward the head's own left.
    friend bool operator==(const Neck&, const Neck&) = default;
};

/// All 0: it looks straight ahead.
struct NeckAngles
{
    float yawRad = 0.0F;   ///< About y, toward the head's own left.
    float pitchRad = 0.0F; ///< Downward, about the axis through both ears; before the yaw.
    friend bool operator==(const NeckAngles&, const NeckAngles&) = default;
};

/// Each begins and ends straight ahead and at rest.
enum class NeckMotion : std::uint8_t
{
    Nod,   ///< 20 degrees down and up, twice in 1.6 s.
    Shake, ///< 35 degrees to both sides, twice in 1.6 s.
    Turn   ///< 60 degrees to the left, then to the right, in 4 s.
};

inline constexpr float kMostYawRad = 1.3962634F;   ///< 80 degrees to either side.
inline constexpr float kMostPitchRad = 0.7853982F; ///< 45 degrees up and down.
inline constexpr double kReturnSeconds = 1.0;      ///< After it a head that was let go looks straight ahead.

/// The neck's base by the landmarks; without them below the mesh's top by as much as people have, or at its base where
/// that is higher.
[[nodiscard]] Neck neckOf(const std::optional<HeadLandmarks>& landmarks, const HeadMesh& mesh);
[[nodiscard]] HeadPose poseOn(const Neck& neck, const NeckAngles& angles);
/// The nearest that a neck does. Numbers that are not finite count as 0.
[[nodiscard]] NeckAngles withinReach(const NeckAngles& angles);

/// So long after it was let go at rest: a critically damped spring brings it back, all but 2 % of it in half a second.
[[nodiscard]] NeckAngles returning(const NeckAngles& from, double seconds);

/// "nod", "shake", "turn".
[[nodiscard]] std::optional<NeckMotion> neckMotionNamed(std::string_view name);
[[nodiscard]] double secondsOf(NeckMotion motion);
/// So long after its beginning; straight ahead before it and after its end. Velocity is continuous. Source: minimum
/// jerk from turning point to turning point, Flash and Hogan, The Coordination of Arm Movements (1985).
[[nodiscard]] NeckAngles anglesAt(NeckMotion motion, double seconds);

} // namespace hairpaint::sim
