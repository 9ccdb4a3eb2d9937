// Each icon is there as its coverage at the sizes that the window shows at 100, 150, 200 and 300 percent:
// ":/icons/SIDE/NAME.png". Others are made from the next larger one.
#include "view/look/icon_drawing.h"

#ifdef HAIRPAINT_DRAWN_ICONS

#include <QDir>
#include <QImage>
#include <QPainter>

#include <algorithm>
#include <vector>

namespace hairpaint::view {

namespace {

/// Ascending.
std::vector<int> drawnSides()
{
    std::vector<int> sides;
    for (const QString& folder : QDir(QStringLiteral(":/icons")).entryList(QDir::Dirs | QDir::NoDotAndDotDot))
        sides.push_back(folder.toInt());
    std::ranges::sort(sides);
    return sides;
}

} // namespace

void drawIcon(QPainter& painter, const QString& name, const QColor& colour)
{
    static const std::vector<int> kSides = drawnSides();
    const QRect whole(0, 0, painter.device()->width(), painter.device()->height());
    const int side = std::min(whole.width(), whole.height());
    if (kSides.empty() || side <= 0)
        return;
    const auto next = std::ranges::lower_bound(kSides, side);
    QImage drawing(QStringLiteral(":/icons/%1/%2.png").arg(next == kSides.end() ? kSides.back() : *next).arg(name));
    drawing = drawing.convertToFormat(QImage::Format_ARGB32_Premultiplied);
    if (drawing.width() != side)
        drawing = drawing.scaled(side, side, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    QPainter colouring(&drawing);
    colouring.setCompositionMode(QPainter::CompositionMode_SourceIn);
    colouring.fillRect(drawing.rect(), QColor(colour.rgb()));
    colouring.end();
    painter.setOpacity(colour.alphaF());
    painter.drawImage(whole.center() - drawing.rect().center(), drawing);
}

} // namespace hairpaint::view

#endif
