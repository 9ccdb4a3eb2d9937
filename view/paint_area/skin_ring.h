// A disc on the skin as it looks on the flat map.
#pragma once

#include "sim/skin/skin.h"

#include <QPolygonF>

namespace hairpaint::view {

/// The circle of `radiusM` around a point in its tangent plane, through the uv map's local derivative: an ellipse of
/// `corners` points, uv. Empty where the map is degenerate there.
[[nodiscard]] QPolygonF ringOnUv(const sim::SurfacePoint& point, float radiusM, int corners = 64);

} // namespace hairpaint::view
