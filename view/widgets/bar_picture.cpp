// Fill or scale, mark, words and frame of a bar.
#include "view/widgets/bar_picture.h"

#include "view/theme.h"
#include "view/widgets/colour_math.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace hairpaint::view {

namespace {

constexpr double kMarkHeight = 5.0; ///< Of the value's mark where words or a scale leave no more.
constexpr int kScaleHeight = 4;     ///< Of the strip that shows a map's scale, under the text.

/// The whole scale is always to be seen; what is not reached is quiet.
void paintScale(QPainter& painter, const QRect& rect, const BarPicture& bar)
{
    const QRectF strip(0.0, rect.height() - kScaleHeight, rect.width(), kScaleHeight);
    QLinearGradient gradient(0.0, 0.0, rect.width(), 0.0);
    const auto last = static_cast<double>(bar.gradient.size() - 1);
    // It runs over values, which the exponent spreads over the bar.
    for (qsizetype i = 0; i < bar.gradient.size(); ++i)
        gradient.setColorAt(std::pow(static_cast<double>(i) / last, 1.0 / bar.exponent), bar.gradient[i]);
    painter.setOpacity(bar.enabled ? 0.3 : 0.1);
    painter.fillRect(strip, gradient);
    painter.setOpacity(bar.enabled ? 1.0 : 0.3);
    painter.fillRect(QRectF(0.0, strip.top(), bar.fraction * rect.width(), strip.height()), gradient);
    painter.setOpacity(1.0);
}

/// The mark leaves the words alone: where it would cross them it shows above and below only.
void paintMark(QPainter& painter, const QRect& rect, const BarPicture& bar, int labelEnd, int valueBegin)
{
    const QColor accent = Theme::current().accent;
    const bool scale = bar.gradient.size() > 1;
    const QRectF mark(std::clamp(bar.fraction * rect.width() - 1.0, 0.0, rect.width() - 2.0), 0.0, 2.0, rect.height());
    const bool crosses = mark.left() < labelEnd + 1 || mark.right() > valueBegin - 1;
    if (scale || crosses)
        painter.fillRect(mark.adjusted(0.0, rect.height() - kMarkHeight, 0.0, 0.0), accent);
    if (!scale && crosses)
        painter.fillRect(mark.adjusted(0.0, 0.0, 0.0, kMarkHeight - rect.height()), accent);
    if (!scale && !crosses)
        painter.fillRect(mark, accent);
}

} // namespace

void paintBar(QPainter& painter, const QRect& rect, const BarPicture& bar)
{
    const Theme theme = Theme::current();
    painter.setRenderHint(QPainter::Antialiasing);
    QPainterPath outline;
    outline.addRoundedRect(QRectF(rect).adjusted(0.5, 0.5, -0.5, -0.5), metrics::kRadius, metrics::kRadius);
    const double edge = bar.fraction * rect.width();
    const QColor ground = bar.enabled ? theme.raised : theme.panel;
    const QRect inside = rect.adjusted(kBarInset, 0, -kBarInset, 0);
    const QFontMetrics font = painter.fontMetrics();
    const int valueWidth = font.horizontalAdvance(bar.value);
    const QString label = font.elidedText(bar.label, Qt::ElideRight, inside.width() - valueWidth - metrics::kGrid);

    painter.fillPath(outline, ground);
    painter.save();
    painter.setClipPath(outline);
    if (bar.gradient.size() > 1)
        paintScale(painter, rect, bar);
    else
        painter.fillRect(QRectF(0.0, 0.0, edge, rect.height()), mixed(ground, theme.accent, bar.enabled ? 0.30 : 0.08));
    if (bar.enabled && edge > 0.0)
        paintMark(painter, rect, bar, inside.left() + font.horizontalAdvance(label), inside.right() - valueWidth);
    painter.restore();

    painter.setPen(bar.enabled ? theme.text : theme.dimText);
    painter.drawText(inside, Qt::AlignLeft | Qt::AlignVCenter, label);
    painter.drawText(inside, Qt::AlignRight | Qt::AlignVCenter, bar.value);
    painter.setPen(
        QPen(bar.focused ? theme.accent : (bar.hovered ? theme.dimText : theme.line), bar.focused ? 1.5 : 1.0));
    painter.drawPath(outline);
}

} // namespace hairpaint::view
