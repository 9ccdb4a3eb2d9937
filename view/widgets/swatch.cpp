// A button that shows a colour.
#include "view/widgets/swatch.h"

#include "view/look/icons.h"
#include "view/look/theme.h"
#include "view/widgets/colour_math.h"

#include <QPainter>

namespace hairpaint::view {

namespace {

constexpr int kPlain = 24;
constexpr int kCaption = 16;

} // namespace

Swatch::Swatch(const QColor& colour, const QString& name, QWidget* parent) : QAbstractButton(parent), m_colour(colour)
{
    setFocusPolicy(Qt::TabFocus);
    setCheckable(true);
    setToolTip(name);
    setAccessibleName(name);
    setFont(themeFont(TextRole::Status));
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void Swatch::setColour(const QColor& colour)
{
    m_colour = colour;
    update();
}

void Swatch::setCaption(const QString& caption)
{
    m_caption = caption;
    updateGeometry();
    update();
}

QSize Swatch::sizeHint() const
{
    if (m_caption.isEmpty())
        return {kPlain, kPlain};
    return {std::max(kPlain + 8, fontMetrics().horizontalAdvance(m_caption) + 4), kPlain + kCaption};
}

void Swatch::paintEvent(QPaintEvent* /*event*/)
{
    const Theme theme = Theme::current();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF all(0.0, 0.0, width(), m_caption.isEmpty() ? height() : height() - kCaption);
    const QRectF field = all.adjusted(2.5, 2.5, -2.5, -2.5);
    painter.setPen(QPen(theme.line, 1.0));
    painter.setBrush(isEnabled() ? m_colour : mixed(theme.panel, m_colour, 0.3));
    painter.drawRoundedRect(field, 3.0, 3.0);
    if (isChecked()) {
        const QPixmap tick = iconPixmap(QStringLiteral("check"), 14, inkOn(m_colour), devicePixelRatioF());
        painter.drawPixmap(QPointF(field.center().x() - 7.0, field.center().y() - 7.0), tick);
    }
    if (isChecked() || hasFocus() || underMouse()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(isChecked() || hasFocus() ? theme.accent : theme.dimText, hasFocus() ? 2.0 : 1.5));
        painter.drawRoundedRect(all.adjusted(1.0, 1.0, -1.0, -1.0), 4.0, 4.0);
    }
    if (!m_caption.isEmpty()) {
        painter.setPen(isChecked() ? theme.text : theme.dimText);
        painter.drawText(QRectF(0.0, all.bottom(), width(), kCaption), Qt::AlignCenter, m_caption);
    }
}

} // namespace hairpaint::view
