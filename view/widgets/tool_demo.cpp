// Rows of hairs from the side, and the pointer's ring.
#include "view/widgets/tool_demo.h"

#include "view/look/theme.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace hairpaint::view {

namespace {

constexpr int kPlayMs = 2600;
/// Fraction of the time that the stroke takes; in the rest its result is shown.
constexpr double kStrokeFraction = 0.75;
constexpr int kRows = 3;

} // namespace

ToolDemo::ToolDemo(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    m_play.setDuration(kPlayMs);
    m_play.setLoopCount(-1);
    m_play.setStartValue(0.0);
    m_play.setEndValue(1.0);
    connect(&m_play, &QVariantAnimation::valueChanged, this, qOverload<>(&QWidget::update));
}

void ToolDemo::setStroke(const model::DemoStroke& stroke)
{
    m_stroke = &stroke;
    m_play.setCurrentTime(0);
    update();
}

void ToolDemo::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    m_play.start();
}

void ToolDemo::hideEvent(QHideEvent* event)
{
    m_play.stop();
    QWidget::hideEvent(event);
}

void ToolDemo::paintEvent(QPaintEvent* /*event*/)
{
    using model::DemoHair;
    using model::DemoMoment;
    const Theme theme = Theme::current();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.window);
    painter.drawRoundedRect(QRectF(rect()), metrics::kRadius, metrics::kRadius);
    if (m_stroke == nullptr)
        return;
    painter.setClipRect(rect());

    const QRectF area = QRectF(rect()).adjusted(14.0, DemoHair::kLengthPx + 6.0, -14.0, -8.0);
    const auto placed = [&area](QPointF at) {
        return area.topLeft() + QPointF(at.x() * area.width(), at.y() * area.height());
    };
    DemoMoment moment;
    moment.area = area;
    moment.start = placed(m_stroke->from);
    moment.done = std::clamp(m_play.currentValue().toDouble() / kStrokeFraction, 0.0, 1.0);
    moment.pointer = placed(m_stroke->from + (m_stroke->to - m_stroke->from) * moment.done);
    painter.setPen(QPen(theme.text, 1.6, Qt::SolidLine, Qt::RoundCap));
    for (moment.row = 0; moment.row < kRows; ++moment.row)
        for (moment.column = 0; moment.column < DemoMoment::kColumns; ++moment.column) {
            moment.root = area.topLeft() + QPointF(area.width() * moment.column / (DemoMoment::kColumns - 1),
                                                   area.height() * moment.row / (kRows - 1));
            const DemoHair hair = m_stroke->hair(moment);
            const QPointF direction(std::cos(hair.angle), std::sin(hair.angle));
            painter.drawLine(moment.root, moment.root + direction * std::max(0.1, hair.lengthPx));
        }
    painter.setPen(QPen(theme.accent, 2.0));
    painter.setBrush(Qt::NoBrush);
    if (m_stroke->drawsLine) {
        painter.drawLine(moment.start, moment.pointer);
        painter.setBrush(theme.accent);
        painter.drawEllipse(moment.pointer, 3.0, 3.0);
    } else {
        painter.drawEllipse(moment.pointer, DemoMoment::kRingPx, DemoMoment::kRingPx);
    }
}

} // namespace hairpaint::view
