// The legend of a map's colours.
#include "view/paint_area/map_legend.h"

#include "model/maps/map_colours.h"
#include "view/look/theme.h"
#include "view/look/value_text.h"

#include <QLocale>
#include <QPainter>
#include <QSinglePointEvent>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace hairpaint::view {

namespace {

constexpr int kWidth = 184;
constexpr int kBar = 12;
constexpr int kLine = 18;
constexpr double kLeastTickGap = 0.15; ///< Least distance of two ticks, as a fraction of the bar's width.
constexpr int kNear = 24;              ///< Margin around the card in which the pointer counts as near, px.
constexpr int kFadeMs = 150;
constexpr double kFadedOpacity = 0.12;
constexpr int kMostOfArea = 4; ///< A card higher than the area's height over this is folded.

/// Round numbers that keep their distance on the bar, with both ends.
QList<MapLegend::Tick> ticksOf(const sim::GroupSettings& settings, const model::MapSpec& spec)
{
    const ValueUnit unit = valueUnit(settings, spec.kind);
    const auto tickAt = [&](double shown) {
        const double value = mapValue(settings, spec.kind, shown);
        return MapLegend::Tick{static_cast<double>(model::shownFraction(spec, static_cast<float>(value))),
                               QLocale().toString(shown, 'g', 4)};
    };
    QList<MapLegend::Tick> ticks{tickAt(unit.minimum), tickAt(unit.maximum)};
    constexpr int kDecades = 4;
    const int highest = static_cast<int>(std::ceil(std::log10(std::max(unit.maximum, 1e-3))));
    for (int decade = highest; decade > highest - kDecades; --decade) {
        for (const double step : {5.0, 2.0, 1.0}) {
            const double shown = step * std::pow(10.0, decade);
            if (shown <= unit.minimum || shown >= unit.maximum)
                continue;
            const MapLegend::Tick tick = tickAt(shown);
            const auto isNear = [&tick](const MapLegend::Tick& other) {
                return std::abs(other.fraction - tick.fraction) < kLeastTickGap;
            };
            if (std::ranges::none_of(ticks, isNear))
                ticks.append(tick);
        }
    }
    std::ranges::sort(ticks, {}, &MapLegend::Tick::fraction);
    return ticks;
}

} // namespace

MapLegend::MapLegend(QWidget* parent) : QWidget(parent)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAccessibleName(tr("What the colours mean"));
    parent->installEventFilter(this);
    m_fading.setDuration(kFadeMs);
    m_fading.setStartValue(1.0);
    m_fading.setEndValue(kFadedOpacity);
    connect(&m_fading, &QVariantAnimation::valueChanged, this, qOverload<>(&QWidget::update));
    hide();
}

void MapLegend::showMap(const model::MapSpec& spec, const sim::GroupSettings& settings, bool nightPaper)
{
    if (!isHidden() && m_spec == &spec && m_settings == settings && m_nightPaper == nightPaper)
        return;
    m_spec = &spec;
    m_settings = settings;
    m_nightPaper = nightPaper;
    m_title = spec.titleText();
    m_labels.clear();
    m_colours.clear();
    m_ticks.clear();
    m_isScale = spec.scale != nullptr;
    if (m_isScale) {
        m_labels.append(rangeText(settings, spec));
        m_colours = {QColor(model::shownColour(spec, 0, nightPaper)),
                     QColor(model::shownColour(spec, 65535, nightPaper))};
        m_ticks = ticksOf(settings, spec);
        m_title = tr("%1, %2").arg(spec.titleText(), valueUnit(settings, spec.kind).unit);
    }
    if (spec.texel == model::TexelKind::Vector) {
        const std::array<std::pair<QString, glm::vec2>, 5> directions{
            std::pair(tr("Upright"), glm::vec2(0.0F, 0.0F)), std::pair(tr("Up the map"), glm::vec2(0.0F, 1.0F)),
            std::pair(tr("Down the map"), glm::vec2(0.0F, -1.0F)), std::pair(tr("To the left"), glm::vec2(-1.0F, 0.0F)),
            std::pair(tr("To the right"), glm::vec2(1.0F, 0.0F))};
        for (const auto& [text, direction] : directions) {
            m_labels.append(text);
            m_colours.append(valueColour(spec, {.direction = direction}, nightPaper));
        }
    }
    for (std::size_t i = 0; i < spec.palette.size(); ++i) {
        model::PaintValue value;
        value.index = static_cast<int>(i);
        m_labels.append(spec.palette[i].titleText());
        m_colours.append(valueColour(spec, value, nightPaper));
    }
    reposition();
    show();
    raise();
    update();
}

void MapLegend::reposition()
{
    const QSize area = parentWidget()->size();
    const int lines = static_cast<int>(m_labels.size()) + 1;
    const int whole = 2 * metrics::kGap + lines * kLine + (m_isScale ? kBar + metrics::kGrid : 0);
    m_folded = !m_isScale && (whole > area.height() / kMostOfArea || 2 * kWidth > area.width());
    resize(kWidth, m_folded ? 2 * metrics::kGap + 2 * kLine : whole);
    move(metrics::kPadding, area.height() - height() - metrics::kPadding);
}

void MapLegend::setFaded(bool faded)
{
    if (std::exchange(m_faded, faded) == faded)
        return;
    m_fading.setDirection(faded ? QAbstractAnimation::Forward : QAbstractAnimation::Backward);
    m_fading.start();
}

bool MapLegend::eventFilter(QObject* watched, QEvent* event)
{
    if (event->isSinglePointEvent())
        setFaded(geometry()
                     .adjusted(-kNear, -kNear, kNear, kNear)
                     .contains(static_cast<QSinglePointEvent*>(event)->position().toPoint()));
    else if (event->type() == QEvent::Leave)
        setFaded(false);
    else if (event->type() == QEvent::Resize && !isHidden())
        reposition();
    return QWidget::eventFilter(watched, event);
}

void MapLegend::paintScale(QPainter& painter, const QRect& line) const
{
    const Theme theme = Theme::current();
    const QRectF bar(line.left(), line.top() + 2, line.width(), kBar);
    // Mixing the two ends evenly gives the colours between, since the bar is even in what is shown.
    QLinearGradient gradient(bar.topLeft(), bar.topRight());
    gradient.setColorAt(0.0, m_colours.constFirst());
    gradient.setColorAt(1.0, m_colours.constLast());
    painter.setPen(theme.line);
    painter.setBrush(gradient);
    painter.drawRoundedRect(bar, 2, 2);
    for (const Tick& tick : m_ticks) {
        const double x = bar.left() + tick.fraction * bar.width();
        const double width = painter.fontMetrics().horizontalAdvance(tick.text);
        painter.setPen(theme.dimText);
        painter.drawLine(QPointF(x, bar.bottom()), QPointF(x, bar.bottom() + 3.0));
        const double left = std::clamp(x - width / 2.0, bar.left(), bar.right() - width);
        painter.drawText(QRectF(left, bar.bottom() + 3.0, width + 1.0, kLine), Qt::AlignLeft | Qt::AlignTop, tick.text);
    }
}

void MapLegend::paintFolded(QPainter& painter, const QRect& line) const
{
    painter.setPen(Theme::current().line);
    const double step =
        std::min<double>(kBar + metrics::kGrid, line.width() / std::max(1.0, static_cast<double>(m_colours.size())));
    for (qsizetype i = 0; i < m_colours.size(); ++i) {
        painter.setBrush(m_colours[i]);
        painter.drawRoundedRect(QRectF(line.left() + static_cast<double>(i) * step, line.top() + 3, kBar, kBar), 2, 2);
    }
}

void MapLegend::paintEvent(QPaintEvent* /*event*/)
{
    const Theme theme = Theme::current();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setOpacity(m_fading.currentValue().toDouble());
    painter.setPen(theme.line);
    painter.setBrush(theme.panel);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), metrics::kRadius, metrics::kRadius);
    QRect line = rect().adjusted(metrics::kPadding, metrics::kGap, -metrics::kPadding, -metrics::kGap);
    line.setHeight(kLine);
    painter.setFont(themeFont(TextRole::Label));
    painter.setPen(theme.text);
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, m_title);
    line.translate(0, kLine);
    painter.setFont(themeFont(TextRole::Status));
    if (m_isScale) {
        paintScale(painter, line);
        return;
    }
    if (m_folded) {
        paintFolded(painter, line);
        return;
    }
    for (qsizetype i = 0; i < m_labels.size(); ++i, line.translate(0, kLine)) {
        QRect text = line;
        painter.setPen(theme.line);
        painter.setBrush(m_colours[i]);
        painter.drawRoundedRect(QRectF(line.left(), line.top() + 3, kBar, kBar), 2, 2);
        text.setLeft(line.left() + kBar + metrics::kGap);
        painter.setPen(theme.dimText);
        painter.drawText(text, Qt::AlignLeft | Qt::AlignVCenter, m_labels[i]);
    }
}

} // namespace hairpaint::view
