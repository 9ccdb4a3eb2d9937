// The head turned on its neck: how far it may be, how it comes back, and motions that it goes through by itself.
#pragma once

#include "sim/motion/strand_frame.h"
#include "sim/skin/neck.h"

#include <cstdint>
#include <optional>
#include <string_view>

namespace hairpaint::sim {

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
