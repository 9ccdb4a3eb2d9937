// From pointer speed to wind.
#include "view/head_area/puff_gesture.h"

#include <algorithm>

namespace hairpaint::view {

namespace {

constexpr float kLeastSpeed = 0.5F;  ///< m/s of the pointer on the head.
constexpr float kMostSpeed = 2.5F;   ///< m/s of the air.
constexpr float kAirPerSpeed = 0.8F; ///< A hand moves about as much air.
constexpr double kPauseSeconds = 0.04;
constexpr double kForgetSeconds = 0.15;
constexpr float kReachM = 0.28F; ///< From the head's centre; long hair hangs that far.

} // namespace

std::optional<Puff> PuffGesture::moved(glm::vec3 positionWo, double seconds)
{
    const std::optional<Sample> last = std::exchange(m_last, Sample{positionWo, seconds});
    if (!last || seconds <= last->seconds || seconds - last->seconds > kForgetSeconds ||
        seconds - m_lastPuff < kPauseSeconds)
        return std::nullopt;
    const glm::vec3 velocity = (positionWo - last->positionWo) / static_cast<float>(seconds - last->seconds);
    const float speed = glm::length(velocity);
    if (speed < kLeastSpeed)
        return std::nullopt;
    m_lastPuff = seconds;
    return Puff{.centreWo = positionWo,
                .velocity = velocity * (std::min(kMostSpeed, speed * kAirPerSpeed) / speed),
                .radiusM = 0.05F};
}

std::optional<glm::vec3> pointNearHair(const RayWo& ray, const sim::HeadPose& pose,
                                       const std::optional<sim::SurfacePoint>& hit)
{
    if (hit)
        return inWorld(hit->positionHd, pose);
    const float along = glm::dot(pose.positionWo - ray.originWo, ray.directionWo);
    const glm::vec3 nearest = ray.originWo + ray.directionWo * along;
    if (glm::length(nearest - pose.positionWo) > kReachM)
        return std::nullopt;
    return nearest;
}

} // namespace hairpaint::view
