// A step along the gradient.
#include "sim/groom/skin_distance.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::sim {

glm::vec3 SkinDistance::pushedOut(glm::vec3 point, float clearanceM, glm::vec3 centreHd) const
{
    if (!m_grid) {
        const SurfacePoint nearest = m_skin->nearest(point);
        const float distanceM = glm::dot(point - nearest.positionHd, nearest.normalHd);
        return distanceM >= clearanceM ? point : point + nearest.normalHd * (clearanceM - distanceM);
    }
    for (int stride = 0; stride < kMostStrides; ++stride) {
        const std::optional<DistanceGrid::Sample> sample = m_grid->at(point);
        if (!sample || sample->distanceM >= clearanceM)
            return point;
        const float slope2 = glm::dot(sample->gradient, sample->gradient);
        if (slope2 >= kLeastSlope2)
            return point + sample->gradient * ((clearanceM - sample->distanceM) / slope2);
        // Deeper than distances are known.
        const glm::vec3 outward = point - centreHd;
        const float length = std::sqrt(glm::dot(outward, outward));
        if (!(length > 1e-6F))
            return point;
        point += outward * (DistanceGrid::kReachM / length);
    }
    return point;
}

} // namespace hairpaint::sim
