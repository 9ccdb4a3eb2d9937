// A pointer that sweeps through the hair blows a puff of air.
#pragma once

#include "view/head_area/head_camera.h"

#include <optional>

namespace hairpaint::view {

struct Puff
{
    glm::vec3 centreWo{0.0F};
    glm::vec3 velocity{0.0F}; ///< m/s
    float radiusM = 0.05F;
};

/// Fed with every move of a pointer without buttons. Slow moves, as when aiming the brush, do nothing.
class PuffGesture
{
public:
    /// `positionWo`: where the pointer is in the world, at the hair's depth.
    [[nodiscard]] std::optional<Puff> moved(glm::vec3 positionWo, double seconds);
    void interrupt() { m_last.reset(); }

private:
    struct Sample
    {
        glm::vec3 positionWo;
        double seconds;
    };
    std::optional<Sample> m_last;
    double m_lastPuff = -1.0;
};

/// Where a ray passes the hair: the skin it hits, else the ray's nearest point to the head; none far from the head.
[[nodiscard]] std::optional<glm::vec3> pointNearHair(const RayWo& ray, const sim::HeadPose& pose,
                                                     const std::optional<sim::SurfacePoint>& hit);

} // namespace hairpaint::view
