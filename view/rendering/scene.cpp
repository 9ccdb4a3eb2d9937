// The orbiting camera.
#include "view/rendering/scene.h"

#include "sim/base/deterministic.h"

#include <glm/gtc/matrix_transform.hpp>

namespace hairpaint::rendering {

glm::vec3 Camera::eyeWo() const
{
    const glm::vec3 direction(sim::sinDet(azimuthRad) * sim::cosDet(elevationRad), sim::sinDet(elevationRad),
                              sim::cosDet(azimuthRad) * sim::cosDet(elevationRad));
    return targetWo + direction * distanceM;
}

glm::mat4 Camera::view() const
{
    // Up is turned with the eye, so that looking straight down has no singular point.
    const glm::vec3 up(-sim::sinDet(azimuthRad) * sim::sinDet(elevationRad), sim::cosDet(elevationRad),
                       -sim::cosDet(azimuthRad) * sim::sinDet(elevationRad));
    return glm::lookAt(eyeWo(), targetWo, up);
}

glm::mat4 Camera::projection(float aspect) const
{
    const float half = fieldOfViewRad * 0.5F;
    const float scale = sim::cosDet(half) / sim::sinDet(half);
    const float nearM = distanceM * 0.05F;
    const float farM = distanceM + 4.0F;
    // As glm::perspective, whose tangent is each machine's own.
    glm::mat4 m(0.0F);
    m[0][0] = scale / aspect;
    m[1][1] = scale;
    m[2][2] = (farM + nearM) / (nearM - farM);
    m[2][3] = -1.0F;
    m[3][2] = 2.0F * farM * nearM / (nearM - farM);
    return m;
}

} // namespace hairpaint::rendering
