// One style of the strip.
#include "view/panels/style_tile.h"

#include "view/theme.h"
#include "view/widgets/colour_math.h"
#include "view/widgets/icons.h"

#include <QPainter>
#include <QPainterPath>

namespace hairpaint::view {

StyleTile::StyleTile(const QString& path, const QString& name, bool own, QWidget* parent)
    : QAbstractButton(parent), m_path(path), m_own(own)
{
    setText(name);
    setAccessibleName(name);
    setFocusPolicy(Qt::TabFocus);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setAttribute(Qt::WA_Hover);
}

void StyleTile::setPicture(const QImage& picture)
{
    m_picture = picture;
    update();
}

void StyleTile::setBusy(bool busy)
{
    if (busy == m_busy)
        return;
    m_busy = busy;
    update();
}

void StyleTile::enterEvent(QEnterEvent* event)
{
    Q_EMIT entered();
    QAbstractButton::enterEvent(event);
}

void StyleTile::leaveEvent(QEvent* event)
{
    Q_EMIT left();
    QAbstractButton::leaveEvent(event);
}

void StyleTile::paintEvent(QPaintEvent* /*event*/)
{
    const Theme theme = Theme::current();
    const qreal ratio = devicePixelRatioF();
    QPainter painter(this);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    const QRectF picture(2.0, 2.0, kPicture, kPicture);
    QPainterPath frame;
    frame.addRoundedRect(picture, 6.0, 6.0);
    painter.fillPath(frame, m_path.isEmpty() ? theme.panel : theme.raised);
    const auto drawIcon = [&](const QString& name, const QColor& colour) {
        painter.drawPixmap(QPointF(picture.center().x() - 16.0, picture.center().y() - 16.0),
                           iconPixmap(name, 32, colour, ratio));
    };
    if (m_path.isEmpty()) {
        drawIcon(QStringLiteral("style-add"), theme.text);
    } else if (m_picture.isNull()) {
        drawIcon(QStringLiteral("hair"), mixed(theme.raised, theme.dimText, 0.7));
    } else {
        painter.save();
        painter.setClipPath(frame);
        const QSizeF size = QSizeF(m_picture.size()).scaled(picture.size(), Qt::KeepAspectRatioByExpanding);
        painter.drawImage(QRectF(picture.center().x() - size.width() / 2.0, picture.center().y() - size.height() / 2.0,
                                 size.width(), size.height()),
                          m_picture);
        painter.restore();
    }
    const bool marked = underMouse() || hasFocus();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(m_path.isEmpty() ? QPen(marked ? theme.accent : theme.dimText, marked ? 2.0 : 1.0, Qt::DashLine)
                                    : QPen(marked ? theme.accent : theme.line, marked ? 2.0 : 1.0));
    painter.drawPath(frame);
    painter.setFont(themeFont(TextRole::Status));
    painter.setPen(marked ? theme.text : theme.dimText);
    const QRectF caption(2.0, picture.bottom() + 4.0, kPicture, 16.0);
    const QString words = m_busy ? tr("Loading…") : text();
    painter.drawText(caption, Qt::AlignCenter,
                     painter.fontMetrics().elidedText(words, Qt::ElideRight, static_cast<int>(caption.width())));
}

} // namespace hairpaint::view
