// Angles of the neck over time, and the pose that they give.
#include "sim/motion/neck_motion.h"

#include "sim/base/deterministic.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace hairpaint::sim {

namespace {

/// A moment at which the head stands still.
struct TurningPoint
{
    double seconds;
    float yawDegrees;
    float pitchDegrees;
};

constexpr std::array<TurningPoint, 6> kNod = {{
    {0.0, 0.0F, 0.0F},
    {0.2, 0.0F, 20.0F},
    {0.6, 0.0F, -20.0F},
    {1.0, 0.0F, 20.0F},
    {1.4, 0.0F, -20.0F},
    {1.6, 0.0F, 0.0F},
}};
constexpr std::array<TurningPoint, 6> kShake = {{
    {0.0, 0.0F, 0.0F},
    {0.2, 35.0F, 0.0F},
    {0.6, -35.0F, 0.0F},
    {1.0, 35.0F, 0.0F},
    {1.4, -35.0F, 0.0F},
    {1.6, 0.0F, 0.0F},
}};
constexpr std::array<TurningPoint, 4> kTurn = {{
    {0.0, 0.0F, 0.0F},
    {1.0, 60.0F, 0.0F},
    {3.0, -60.0F, 0.0F},
    {4.0, 0.0F, 0.0F},
}};

struct MotionRow
{
    std::string_view name;
    std::span<const TurningPoint> points;
};

/// In the order of NeckMotion.
constexpr std::array<MotionRow, 3> kMotions = {{{"nod", kNod}, {"shake", kShake}, {"turn", kTurn}}};

std::span<const TurningPoint> pointsOf(NeckMotion motion)
{
    return kMotions[static_cast<std::size_t>(motion)].points;
}

glm::quat turnAbout(glm::vec3 axis, float radians)
{
    const glm::vec3 v = axis * sinDet(radians * 0.5F);
    return {cosDet(radians * 0.5F), v.x, v.y, v.z};
}

} // namespace

HeadPose poseOn(const Neck& neck, const NeckAngles& angles)
{
    HeadPose pose;
    pose.rotation = turnAbout(glm::vec3(0.0F, 1.0F, 0.0F), angles.yawRad) * turnAbout(neck.acrossHd, angles.pitchRad);
    pose.positionWo = neck.pivotHd - pose.rotation * neck.pivotHd;
    return pose;
}

NeckAngles withinReach(const NeckAngles& angles)
{
    const auto limited = [](float radians, float most) {
        return std::isfinite(radians) ? std::clamp(radians, -most, most) : 0.0F;
    };
    return {limited(angles.yawRad, kMostYawRad), limited(angles.pitchRad, kMostPitchRad)};
}

NeckAngles returning(const NeckAngles& from, double seconds)
{
    constexpr double kRate = 12.0; // rad/s of the spring
    if (seconds <= 0.0)
        return from;
    if (seconds >= kReturnSeconds)
        return {};
    const auto phase = static_cast<float>(kRate * seconds);
    const float left = (1.0F + phase) * expDet(-phase);
    return {from.yawRad * left, from.pitchRad * left};
}

std::optional<NeckMotion> neckMotionNamed(std::string_view name)
{
    const auto* const found =
        std::ranges::find_if(kMotions, [name](const MotionRow& motion) { return motion.name == name; });
    if (found == kMotions.end())
        return std::nullopt;
    return static_cast<NeckMotion>(found - kMotions.begin());
}

double secondsOf(NeckMotion motion)
{
    return pointsOf(motion).back().seconds;
}

NeckAngles anglesAt(NeckMotion motion, double seconds)
{
    constexpr float kRadPerDegree = 0.017453293F;
    const std::span<const TurningPoint> points = pointsOf(motion);
    const auto next = std::ranges::find_if(points, [seconds](const TurningPoint& p) { return p.seconds > seconds; });
    if (next == points.begin() || next == points.end())
        return {};
    const TurningPoint& from = *(next - 1);
    const double t = (seconds - from.seconds) / (next->seconds - from.seconds);
    const auto s = static_cast<float>(t * t * t * (10.0 + t * (6.0 * t - 15.0)));
    return {(from.yawDegrees + (next->yawDegrees - from.yawDegrees) * s) * kRadPerDegree,
            (from.pitchDegrees + (next->pitchDegrees - from.pitchDegrees) * s) * kRadPerDegree};
}

} // namespace hairpaint::sim
