// The picture of a filled bar.
#pragma once

#include <QColor>
#include <QList>
#include <QString>

class QPainter;
class QRect;

namespace hairpaint::view {

inline constexpr int kBarInset = 8; ///< Distance of its words from its ends, px.

struct BarPicture
{
    QString label; ///< Left; shortened where the value leaves no room.
    QString value; ///< Right.
    double fraction = 0.0;
    QList<QColor> gradient; ///< A map's scale, instead of the plain fill.
    double exponent = 1.0;  ///< How the scale is spread over the bar.
    bool enabled = true;
    bool hovered = false;
    bool focused = false;
};
void paintBar(QPainter& painter, const QRect& rect, const BarPicture& bar);

} // namespace hairpaint::view
