// The orbiting camera.
#include "view/rendering/scene.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace hairpaint::rendering {

glm::vec3 Camera::eyeWo() const
{
    const glm::vec3 direction(std::sin(azimuthRad) * std::cos(elevationRad), std::sin(elevationRad),
                              std::cos(azimuthRad) * std::cos(elevationRad));
    return targetWo + direction * distanceM;
}

glm::mat4 Camera::view() const
{
    // Up is turned with the eye, so that looking straight down has no singular point.
    const glm::vec3 up(-std::sin(azimuthRad) * std::sin(elevationRad), std::cos(elevationRad),
                       -std::cos(azimuthRad) * std::sin(elevationRad));
    return glm::lookAt(eyeWo(), targetWo, up);
}

glm::mat4 Camera::projection(float aspect) const
{
    return glm::perspective(fieldOfViewRad, aspect, distanceM * 0.05F, distanceM + 4.0F);
}

} // namespace hairpaint::rendering
