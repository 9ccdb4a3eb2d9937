// Draws short tapered hairs over a direction map.
#pragma once

#include "sim/base/tiled_raster.h"
#include "view/paint_area/uv_transform.h"

#include <QImage>
#include <QPainter>

namespace hairpaint::view {

/// How far a hair may reach from its root, px; the area repainted after a change grows by it.
inline constexpr int kFieldHairReachPx = 22;

/// Hairs whose size and distance are in pixels and whose roots stay where they are on the paper, so that they neither
/// swim nor jump when the view moves. The flatter hair lies, the longer; upright hair is a dot. `map`: two channels.
/// `shading`: bakeUvShading's, whose alpha says where there is skin; null: everywhere.
void drawFieldHairs(QPainter& painter, const QRect& dirty, const UvTransform& transform, const sim::TiledRaster& map,
                    const QImage& shading);

} // namespace hairpaint::view
