// How an icon's drawing becomes pixels: by Qt Svg, or from pictures that were drawn when the program was built, where
// there is no Qt Svg (HAIRPAINT_DRAWN_ICONS, a folder of resources/packaging/windows/icons).
#pragma once

#include <QColor>
#include <QString>

class QPainter;

namespace hairpaint::view {

/// Draws ":/icons/NAME.svg" in `colour` over all of what `painter` paints on, centred, in its own proportions.
void drawIcon(QPainter& painter, const QString& name, const QColor& colour);

} // namespace hairpaint::view
