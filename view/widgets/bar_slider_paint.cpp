// The picture of the filled bar.
#include "view/theme.h"
#include "view/widgets/bar_slider.h"
#include "view/widgets/colour_math.h"

#include <QEvent>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace hairpaint::view {

namespace {

constexpr int kInset = 8;
constexpr double kMarkHeight = 5.0; ///< Of the value's mark where words or a scale leave no more.
constexpr int kScaleHeight = 4;     ///< Of the strip that shows a map's scale, under the text.

/// Degrees stand against their number, other units a thin space away.
QString spacedUnit(const QString& unit)
{
    return unit.isEmpty() || unit == QStringLiteral("°") ? unit : QChar(0x2009) + unit;
}

} // namespace

QString BarSlider::valueText() const
{
    const QString number = QLocale().toString(m_value, 'f', m_decimals);
    return number + spacedUnit(m_unit);
}

QSize BarSlider::sizeHint() const
{
    return {std::max(minimumSizeHint().width(), m_preferredWidth), metrics::kSlider};
}

QSize BarSlider::minimumSizeHint() const
{
    const QFontMetrics font = fontMetrics();
    const QString widest = QLocale().toString(m_maximum, 'f', m_decimals) + spacedUnit(m_unit);
    return {font.horizontalAdvance(m_label) + font.horizontalAdvance(widest) + 3 * kInset, metrics::kSlider};
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

    painter.fillPath(outline, ground);
    painter.save();
    painter.setClipPath(outline);
    if (scale) {
        // The whole scale is always to be seen; what is not reached is quiet.
        const QRectF strip(0.0, height() - kScaleHeight, width(), kScaleHeight);
        QLinearGradient gradient(0.0, 0.0, width(), 0.0);
        const auto last = static_cast<double>(m_gradient.size() - 1);
        // It runs over values, which the exponent spreads over the bar.
        for (qsizetype i = 0; i < m_gradient.size(); ++i)
            gradient.setColorAt(std::pow(static_cast<double>(i) / last, 1.0 / m_exponent), m_gradient[i]);
        painter.setOpacity(isEnabled() ? 0.3 : 0.1);
        painter.fillRect(strip, gradient);
        painter.setOpacity(isEnabled() ? 1.0 : 0.3);
        painter.fillRect(QRectF(0.0, strip.top(), edge, strip.height()), gradient);
        painter.setOpacity(1.0);
    } else {
        painter.fillRect(QRectF(0.0, 0.0, edge, height()), mixed(ground, theme.accent, isEnabled() ? 0.30 : 0.08));
    }
    const QRect inside = rect().adjusted(kInset, 0, -kInset, 0);
    const QString value = valueText();
    const int valueWidth = fontMetrics().horizontalAdvance(value);
    const QString label =
        fontMetrics().elidedText(m_label, Qt::ElideRight, inside.width() - valueWidth - metrics::kGrid);
    if (isEnabled() && edge > 0.0) {
        // The mark leaves the words alone: where it would cross them it shows above and below only.
        const QRectF mark(std::clamp(edge - 1.0, 0.0, width() - 2.0), 0.0, 2.0, height());
        const bool crosses = mark.left() < inside.left() + fontMetrics().horizontalAdvance(label) + 1 ||
                             mark.right() > inside.right() - valueWidth - 1;
        if (scale || crosses)
            painter.fillRect(mark.adjusted(0.0, height() - kMarkHeight, 0.0, 0.0), theme.accent);
        if (!scale && crosses)
            painter.fillRect(mark.adjusted(0.0, 0.0, 0.0, kMarkHeight - height()), theme.accent);
        if (!scale && !crosses)
            painter.fillRect(mark, theme.accent);
    }
    painter.restore();

    painter.setPen(isEnabled() ? theme.text : theme.dimText);
    painter.drawText(inside, Qt::AlignLeft | Qt::AlignVCenter, label);
    painter.drawText(inside, Qt::AlignRight | Qt::AlignVCenter, value);
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
