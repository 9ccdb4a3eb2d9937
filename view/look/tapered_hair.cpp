// A hair as two polygons: its edge and itself.
#include "view/look/tapered_hair.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hairpaint::view {

namespace {

constexpr double kRootPx = 1.1;   ///< Half a hair's width at its root,
constexpr double kBendPx = 0.7;   ///< and in its middle; its tip is a point.
constexpr double kShadowPx = 0.9; ///< The dark edge.
constexpr double kLeastPx = 3.0;  ///< Shorter hairs are dots.
constexpr QColor kDark{10, 12, 30, 110};
constexpr QColor kLight{255, 255, 255, 215};

} // namespace

void drawTaperedHair(QPainter& painter, const HairSpine& spine)
{
    const QPointF along = spine[2] - spine[0];
    const double length = std::hypot(along.x(), along.y());
    for (const auto& [colour, more] : {std::pair(kDark, kShadowPx), std::pair(kLight, 0.0)}) {
        painter.setBrush(colour);
        if (length < kLeastPx) {
            painter.drawEllipse(spine[0], kRootPx + more, kRootPx + more);
            continue;
        }
        const QPointF side(-along.y() / length, along.x() / length);
        const std::array<QPointF, 5> outline{spine[0] + side * (kRootPx + more), spine[1] + side * (kBendPx + more),
                                             spine[2] + along * (more / length), spine[1] - side * (kBendPx + more),
                                             spine[0] - side * (kRootPx + more)};
        painter.drawPolygon(outline.data(), static_cast<int>(outline.size()));
    }
}

} // namespace hairpaint::view
