// A spiral that opens.
#include "model/tools/combing/whorl.h"

#include "sim/base/rounded.h"

#include <algorithm>

namespace hairpaint::model {

namespace {

constexpr float kInnerRad = 1.2F; ///< From outward to around, in the middle,
constexpr float kOuterRad = 0.7F; ///< and at the ring.

} // namespace

glm::vec3 Whorl::directionHd(glm::vec2 offsetUv) const
{
    const glm::vec3 offsetHd = centre.dPduHd * offsetUv.x + centre.dPdvHd * offsetUv.y;
    const glm::vec3 inPlane = offsetHd - centre.normalHd * glm::dot(offsetHd, centre.normalHd);
    const float distanceM = glm::length(inPlane);
    if (!(distanceM > 1e-7F))
        return glm::vec3(0.0F);
    const float fraction = std::min(distanceM / radiusM, 1.0F);
    const float angle = kInnerRad + (kOuterRad - kInnerRad) * fraction;
    const glm::vec3 outward = inPlane / distanceM;
    const glm::vec3 clockwiseHd = glm::cross(outward, centre.normalHd);
    const float rise = fraction * fraction * (3.0F - 2.0F * fraction);
    return (outward * sim::cosRounded(angle) + (clockwise ? clockwiseHd : -clockwiseHd) * sim::sinRounded(angle)) *
           (flatness * rise);
}

} // namespace hairpaint::model
