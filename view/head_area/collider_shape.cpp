// Ellipses and the ends of axes.
#include "view/head_area/collider_shape.h"

#include <cmath>
#include <numbers>

namespace hairpaint::view {

std::vector<QPolygonF> colliderOutlines(const sim::Ellipsoid& ellipsoid, const HeadSight& sight)
{
    constexpr int kCorners = 64;
    std::vector<QPolygonF> outlines;
    for (int axis = 0; axis < 3; ++axis) {
        QPolygonF ellipse;
        for (int i = 0; i <= kCorners; ++i) {
            const float angle = 2.0F * std::numbers::pi_v<float> * static_cast<float>(i) / kCorners;
            glm::vec3 own(0.0F);
            own[(axis + 1) % 3] = std::cos(angle);
            own[(axis + 2) % 3] = std::sin(angle);
            const glm::vec3 positionHd = ellipsoid.centreHd + ellipsoid.rotation * (own * ellipsoid.semiAxesM);
            const std::optional<QPointF> at = project(sight.camera, inWorld(positionHd, sight.pose), sight.size);
            if (!at)
                break;
            ellipse.push_back(*at);
        }
        if (ellipse.size() > kCorners)
            outlines.push_back(std::move(ellipse));
    }
    return outlines;
}

glm::vec3 colliderAxis(const sim::Ellipsoid& ellipsoid, int end)
{
    glm::vec3 own(0.0F);
    own[end / 2] = end % 2 == 0 ? 1.0F : -1.0F;
    return ellipsoid.rotation * own;
}

glm::vec3 colliderEnd(const sim::Ellipsoid& ellipsoid, int end)
{
    return ellipsoid.centreHd + colliderAxis(ellipsoid, end) * ellipsoid.semiAxesM[end / 2];
}

} // namespace hairpaint::view
