// Words above, the fill or a map's scale with its mark below them, and the frame of a bar.
#include "view/widgets/bar_picture.h"

#include "view/look/theme.h"
#include "view/widgets/colour_math.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace hairpaint::view {

namespace {

constexpr int kStripHeight = 4; ///< Under the words, which nothing crosses: the fill, or a map's scale.
constexpr double kMarkHeight = 6.0;
constexpr double kMarkWidth = 3.0;

/// The whole scale is always to be seen; what is not reached is quiet.
void paintScale(QPainter& painter, const QRectF& strip, const BarPicture& bar)
{
    QLinearGradient gradient(0.0, 0.0, strip.width(), 0.0);
    const auto last = static_cast<double>(bar.gradient.size() - 1);
    // It runs over values, which the exponent spreads over the bar.
    for (qsizetype i = 0; i < bar.gradient.size(); ++i)
        gradient.setColorAt(std::pow(static_cast<double>(i) / last, 1.0 / bar.exponent), bar.gradient[i]);
    painter.setOpacity(bar.enabled ? 0.3 : 0.1);
    painter.fillRect(strip, gradient);
    painter.setOpacity(bar.enabled ? 1.0 : 0.3);
    painter.fillRect(QRectF(0.0, strip.top(), bar.fraction * strip.width(), strip.height()), gradient);
    painter.setOpacity(1.0);
}

void paintFill(QPainter& painter, const QRectF& strip, const BarPicture& bar)
{
    const Theme theme = Theme::current();
    painter.fillRect(strip, theme.line);
    painter.fillRect(QRectF(0.0, strip.top(), bar.fraction * strip.width(), strip.height()),
                     mixed(theme.line, theme.accent, bar.enabled ? 0.65 : 0.15));
}

} // namespace

void paintBar(QPainter& painter, const QRect& rect, const BarPicture& bar)
{
    const Theme theme = Theme::current();
    painter.setRenderHint(QPainter::Antialiasing);
    QPainterPath outline;
    outline.addRoundedRect(QRectF(rect).adjusted(0.5, 0.5, -0.5, -0.5), metrics::kRadius, metrics::kRadius);
    const QColor ground = bar.enabled ? theme.raised : theme.panel;
    const QRectF strip(0.0, rect.height() - kStripHeight, rect.width(), kStripHeight);
    const QRect words = rect.adjusted(kBarInset, 0, -kBarInset, -kStripHeight);
    const QFontMetrics font = painter.fontMetrics();
    const QString label =
        font.elidedText(bar.label, Qt::ElideRight, words.width() - font.horizontalAdvance(bar.value) - metrics::kGrid);

    painter.fillPath(outline, ground);
    painter.save();
    painter.setClipPath(outline);
    if (bar.gradient.size() > 1)
        paintScale(painter, strip, bar);
    else
        paintFill(painter, strip, bar);
    if (bar.enabled && bar.fraction > 0.0) {
        const double left = std::clamp(bar.fraction * rect.width() - kMarkWidth / 2.0, 0.0, rect.width() - kMarkWidth);
        painter.fillRect(QRectF(left, rect.height() - kMarkHeight, kMarkWidth, kMarkHeight), theme.accent);
    }
    painter.restore();

    painter.setPen(bar.enabled ? theme.text : theme.dimText);
    painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter, label);
    painter.drawText(words, Qt::AlignRight | Qt::AlignVCenter, bar.value);
    painter.setPen(
        QPen(bar.focused ? theme.accent : (bar.hovered ? theme.dimText : theme.line), bar.focused ? 1.5 : 1.0));
    painter.drawPath(outline);
}

} // namespace hairpaint::view
