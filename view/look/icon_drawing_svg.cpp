// The colour is put into the drawing's text.
#include "view/look/icon_drawing.h"

#ifndef HAIRPAINT_DRAWN_ICONS

#include <QFile>
#include <QPainter>
#include <QSvgRenderer>

namespace hairpaint::view {

void drawIcon(QPainter& painter, const QString& name, const QColor& colour)
{
    QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
    QByteArray drawing = file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    drawing.replace("currentColor", colour.name().toLatin1());
    QSvgRenderer renderer(drawing);
    renderer.setAspectRatioMode(Qt::KeepAspectRatio);
    painter.setOpacity(colour.alphaF());
    renderer.render(&painter);
}

} // namespace hairpaint::view

#endif
