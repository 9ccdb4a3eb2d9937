// A map's letter and icon.
#include "view/widgets/map_badge.h"

#include "view/look/icons.h"
#include "view/look/theme.h"
#include "view/widgets/colour_math.h"

#include <QPainter>

namespace hairpaint::view {

namespace {

constexpr int kLetter = 18;

/// The map's colour, quietened so that white or black ink is read on it; maps that are colours themselves are grey.
QColor groundOf(const model::MapSpec& spec, const Theme& theme)
{
    if (spec.texel == model::TexelKind::Colour) // Those of vectors have one of their own.
        return mixed(theme.panel, theme.dimText, 0.7);
    return mixed(theme.panel, QColor::fromRgb(spec.scaleColour), theme.kind == ThemeKind::Dark ? 0.72 : 0.85);
}

} // namespace

MapBadge::MapBadge(model::MapKind map, QWidget* parent) : QWidget(parent), m_map(map)
{
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setMap(map);
}

void MapBadge::setMap(model::MapKind map)
{
    m_map = map;
    setAccessibleName(model::mapSpec(map).titleText());
    setToolTip(accessibleName());
    update();
}

void MapBadge::paint(QPainter& painter, const QRect& rect, const model::MapSpec& spec, bool strong)
{
    const Theme theme = Theme::current();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const int middle = rect.center().y();
    const QRect letter(rect.left(), middle - kLetter / 2 + 1, kLetter, kLetter);
    const QColor ground = groundOf(spec, theme);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground);
    painter.drawRoundedRect(letter, 3.0, 3.0);
    QFont font = themeFont(TextRole::Status);
    font.setWeight(QFont::DemiBold);
    painter.setFont(font);
    painter.setPen(inkOn(ground));
    painter.drawText(letter, Qt::AlignCenter, spec.letterText());
    const qreal ratio = painter.device()->devicePixelRatioF();
    painter.drawPixmap(QPoint(letter.right() + 6, middle - 9),
                       iconPixmap(QLatin1String(spec.id), 20, strong ? theme.text : theme.dimText, ratio));
    painter.restore();
}

void MapBadge::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    paint(painter, rect(), model::mapSpec(m_map), true);
}

} // namespace hairpaint::view
