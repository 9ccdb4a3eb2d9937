// One map in the maps panel.
#include "view/panels/map_row.h"

#include "view/look/theme.h"
#include "view/widgets/map_badge.h"

#include <QPainter>
#include <QPainterPath>

namespace hairpaint::view {

MapRow::MapRow(model::MapKind map, QWidget* parent) : QAbstractButton(parent), m_map(map)
{
    const model::MapSpec& spec = model::mapSpec(map);
    setText(spec.titleText());
    setAccessibleName(spec.titleText());
    setCheckable(true);
    setAutoExclusive(true);
    setFocusPolicy(Qt::TabFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    setMaximumHeight(MapRow::sizeHint().height());
    setAttribute(Qt::WA_Hover);
}

void MapRow::setRange(const QString& range, int size)
{
    const QString texels = size > 0 ? tr("%1 px").arg(size) : QString();
    m_range = range;
    m_rangeAndSize = range.isEmpty() || texels.isEmpty() ? range + texels : range + QStringLiteral("  ·  ") + texels;
    setAccessibleDescription(m_rangeAndSize);
    const int number = static_cast<int>(m_map) + 1;
    const QString name = number <= kDigits ? tr("%1 (%2)").arg(text()).arg(number % kDigits) : text();
    setToolTip(size > 0 ? tr("%1: %2 x %2 texels").arg(name).arg(size) : name);
    update();
}

void MapRow::setThumbnail(const QImage& thumbnail)
{
    m_thumbnail = thumbnail;
    update();
}

void MapRow::paintEvent(QPaintEvent* /*event*/)
{
    const Theme theme = Theme::current();
    QPainter painter(this);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    const QRectF field = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    if (isChecked() || underMouse()) {
        QPainterPath ground;
        ground.addRoundedRect(field, metrics::kRadius, metrics::kRadius);
        painter.fillPath(ground, isChecked() ? theme.raised : theme.window);
        if (isChecked()) {
            painter.save();
            painter.setClipPath(ground);
            painter.fillRect(QRectF(0.0, 0.0, 3.0, height()), theme.accent);
            painter.restore();
        }
    }
    MapBadge::paint(painter, QRect(metrics::kGap, 0, 44, height()), model::mapSpec(m_map), isChecked());
    const QRectF picture(width() - kThumbnailSide - 4.0, (height() - kThumbnailSide) / 2.0, kThumbnailSide,
                         kThumbnailSide);
    if (!m_thumbnail.isNull()) {
        QPainterPath frame;
        frame.addRoundedRect(picture, 3.0, 3.0);
        painter.save();
        painter.setClipPath(frame);
        painter.drawImage(picture, m_thumbnail);
        painter.restore();
        painter.setPen(QPen(theme.line, 1.0));
        painter.drawPath(frame);
    }
    QRectF text(60.0, 0.0, picture.left() - 68.0, height());
    QFont font = themeFont(TextRole::Body);
    if (isChecked())
        font.setWeight(QFont::DemiBold);
    painter.setFont(themeFont(TextRole::Status));
    painter.setPen(theme.dimText);
    // The name goes before the size, which the tooltip has too, and before the range, which the legend has.
    const double room = text.width() - QFontMetricsF(font).horizontalAdvance(this->text()) - 8.0;
    const auto fits = [&](const QString& words) { return painter.fontMetrics().horizontalAdvance(words) <= room; };
    const QString shown = fits(m_rangeAndSize) ? m_rangeAndSize : fits(m_range) ? m_range : QString();
    painter.drawText(text, Qt::AlignRight | Qt::AlignVCenter, shown);
    text.setWidth(text.width() - painter.fontMetrics().horizontalAdvance(shown) - 8.0);
    painter.setFont(font);
    painter.setPen(theme.text);
    painter.drawText(text, Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(this->text(), Qt::ElideRight, static_cast<int>(text.width())));
    if (hasFocus()) {
        painter.setPen(QPen(theme.accent, 1.5));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(field, metrics::kRadius, metrics::kRadius);
    }
}

} // namespace hairpaint::view
