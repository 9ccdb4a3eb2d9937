// The brush ring's ellipse.
#include "view/paint_area/skin_ring.h"

#include <cmath>
#include <numbers>

namespace hairpaint::view {

QPolygonF ringOnUv(const sim::SurfacePoint& point, float radiusM, int corners)
{
    // A step q on the map is |J q| long on the skin. With the metric J'J = L L', the circle is q = r L'^-1 (cos, sin).
    const float uu = glm::dot(point.dPduHd, point.dPduHd);
    const float uv = glm::dot(point.dPduHd, point.dPdvHd);
    const float vv = glm::dot(point.dPdvHd, point.dPdvHd);
    const float l11 = std::sqrt(uu);
    if (!(l11 > 0.0F))
        return {};
    const float l21 = uv / l11;
    const float rest = vv - l21 * l21;
    if (!(rest > 1e-12F * vv))
        return {};
    const float l22 = std::sqrt(rest);
    QPolygonF polygon;
    polygon.reserve(corners);
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / corners;
        const double y = std::sin(angle) / static_cast<double>(l22);
        const double x = (std::cos(angle) - static_cast<double>(l21) * y) / static_cast<double>(l11);
        polygon.push_back(QPointF(static_cast<double>(point.uv.x) + static_cast<double>(radiusM) * x,
                                  static_cast<double>(point.uv.y) + static_cast<double>(radiusM) * y));
    }
    return polygon;
}

} // namespace hairpaint::view
