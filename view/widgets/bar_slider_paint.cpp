// The picture of the filled bar.
#include "view/theme.h"
#include "view/widgets/bar_slider.h"
#include "view/widgets/colour_math.h"

#include <QEvent>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>

#include <cmath>

namespace hairpaint::view {

namespace {

constexpr int kInset = 8;

QColor gradientAt(const QList<QColor>& colours, double fraction)
{
    const double place = fraction * static_cast<double>(colours.size() - 1);
    const auto index = std::min(static_cast<qsizetype>(place), colours.size() - 2);
    return mixed(colours[index], colours[index + 1], place - static_cast<double>(index));
}

} // namespace

QString BarSlider::valueText() const
{
    const QString number = QLocale().toString(m_value, 'f', m_decimals);
    return m_unit.isEmpty() ? number : number + QChar(0x2009) + m_unit;
}

QSize BarSlider::sizeHint() const
{
    const QFontMetrics font = fontMetrics();
    const QString widest = QLocale().toString(m_maximum, 'f', m_decimals) + QChar(0x2009) + m_unit;
    return {font.horizontalAdvance(m_label) + font.horizontalAdvance(widest) + 3 * kInset, metrics::kSlider};
}

QSize BarSlider::minimumSizeHint() const
{
    return sizeHint();
}

void BarSlider::paintEvent(QPaintEvent* /*event*/)
{
    const Theme theme = Theme::current();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF bar = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    QPainterPath outline;
    outline.addRoundedRect(bar, metrics::kRadius, metrics::kRadius);
    const double edge = fractionOf(m_value) * width();
    const bool scale = m_gradient.size() > 1;
    const QColor ground = isEnabled() ? theme.raised : theme.panel;
    const QColor plainFill = mixed(ground, theme.accent, isEnabled() ? 0.30 : 0.08);

    painter.fillPath(outline, ground);
    painter.save();
    painter.setClipPath(outline);
    const QRectF filled(0.0, 0.0, edge, height());
    if (scale && isEnabled()) {
        QLinearGradient gradient(0.0, 0.0, width(), 0.0);
        const double last = static_cast<double>(m_gradient.size() - 1);
        // The scale runs over values, which the exponent spreads over the bar.
        for (qsizetype i = 0; i < m_gradient.size(); ++i)
            gradient.setColorAt(std::pow(static_cast<double>(i) / last, 1.0 / m_exponent), m_gradient[i]);
        painter.fillRect(filled, gradient);
    } else {
        painter.fillRect(filled, plainFill);
    }
    if (isEnabled() && edge > 0.0)
        painter.fillRect(QRectF(std::max(edge - 2.0, 0.0), 0.0, 2.0, height()), theme.accent);
    painter.restore();

    // Text is written light where the bar under it is dark, and dark where it is bright.
    QRegion forLight;
    QRegion forDark;
    const QColor light = theme.kind == ThemeKind::Dark ? theme.text : QColor(Qt::white);
    const QColor dark = theme.kind == ThemeKind::Dark ? theme.window : theme.text;
    for (int x = 0; x < width(); ++x) {
        QColor under = x < edge ? plainFill : ground;
        if (scale && x < edge)
            under = gradientAt(m_gradient, std::pow((x + 0.5) / width(), m_exponent));
        (contrast(light, under) >= contrast(dark, under) ? forLight : forDark) += QRect(x, 0, 1, height());
    }
    const QRect inside = rect().adjusted(kInset, 0, -kInset, 0);
    const QString value = valueText();
    const int valueWidth = fontMetrics().horizontalAdvance(value);
    const QString label =
        fontMetrics().elidedText(m_label, Qt::ElideRight, inside.width() - valueWidth - metrics::kGrid);
    for (const auto& [region, colour] : {std::pair(forLight, light), std::pair(forDark, dark)}) {
        painter.setClipRegion(region);
        painter.setPen(isEnabled() ? colour : theme.dimText);
        painter.drawText(inside, Qt::AlignLeft | Qt::AlignVCenter, label);
        painter.drawText(inside, Qt::AlignRight | Qt::AlignVCenter, value);
    }
    painter.setClipping(false);
    const bool hover = isEnabled() && underMouse();
    painter.setPen(QPen(hasFocus() ? theme.accent : (hover ? theme.dimText : theme.line), hasFocus() ? 1.5 : 1.0));
    painter.drawPath(outline);
}

void BarSlider::enterEvent(QEnterEvent* event)
{
    update();
    QWidget::enterEvent(event);
}

void BarSlider::leaveEvent(QEvent* event)
{
    update();
    QWidget::leaveEvent(event);
}

void BarSlider::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::EnabledChange || event->type() == QEvent::PaletteChange)
        update();
    QWidget::changeEvent(event);
}

} // namespace hairpaint::view
