// Rows of hairs from the side, and the pointer's ring.
#include "view/widgets/tool_demo.h"

#include "view/look/theme.h"

#include <QLineF>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hairpaint::view {

namespace {

constexpr int kPlayMs = 2600;
constexpr double kStrokeFraction = 0.75; ///< Of the time; the rest shows what has come of it.
constexpr int kColumns = 15;
constexpr int kRows = 3;
constexpr double kHairPx = 17.0;
constexpr double kRingPx = 15.0;
constexpr double kUpright = -std::numbers::pi / 2.0;

/// A hair from its root on: where it points and how long it is.
struct DemoHair
{
    double angle = kUpright;
    double lengthPx = kHairPx;
};

struct Moment
{
    QRectF area;
    double done = 0.0; ///< Of the stroke.

    [[nodiscard]] QPointF pointer(QPointF from, QPointF to) const
    {
        const QPointF at = from + (to - from) * done;
        return {area.left() + at.x() * area.width(), area.top() + at.y() * area.height()};
    }
};

/// As hair that nobody has combed: the same at every time.
double unruly(int column, int row)
{
    return kUpright + 0.9 * std::sin(12.9 * column + 7.3 * row);
}

double mixed(double from, double to, double fraction)
{
    return from + (to - from) * std::clamp(fraction, 0.0, 1.0);
}

QPointF pointerOf(model::ToolId tool, const Moment& moment)
{
    switch (tool) {
    case model::ToolId::Part:
        return moment.pointer({0.5, 0.05}, {0.5, 1.0});
    case model::ToolId::Grab:
        return moment.pointer({0.35, 0.45}, {0.62, 0.3});
    default:
        return moment.pointer({0.02, 0.55}, {1.0, 0.55});
    }
}

DemoHair hairOf(model::ToolId tool, const Moment& moment, int column, int row, QPointF root)
{
    const QPointF pointer = pointerOf(tool, moment);
    switch (tool) {
    case model::ToolId::Comb: {
        constexpr double kLaid = -0.25;
        return {.angle = mixed(unruly(column, row), kLaid, (pointer.x() - root.x()) / kRingPx)};
    }
    case model::ToolId::Part: {
        constexpr double kFallen = 1.25;
        const double side = column * 2 < kColumns - 1 ? -1.0 : column * 2 > kColumns - 1 ? 1.0 : 0.0;
        const double near = 1.0 - std::abs(root.x() - moment.area.center().x()) / (0.4 * moment.area.width());
        const double passed = std::clamp((pointer.y() - root.y()) / kRingPx + 1.0, 0.0, 1.0);
        return {.angle = kUpright + side * kFallen * passed * std::clamp(near * 2.0, 0.0, 1.0),
                .lengthPx = side == 0.0 ? kHairPx * (1.0 - passed) : kHairPx};
    }
    case model::ToolId::Grab: {
        const QPointF taken = Moment{moment.area, 0.0}.pointer({0.35, 0.45}, {0.62, 0.3});
        const double held = std::clamp(1.6 - QLineF(root, taken).length() / (1.6 * kRingPx), 0.0, 1.0);
        const QPointF tip = root + QPointF(0.0, -kHairPx) + (pointer - taken) * held;
        return {.angle = std::atan2(tip.y() - root.y(), tip.x() - root.x())};
    }
    case model::ToolId::Fingers: {
        constexpr double kLying = -0.3;
        constexpr double kPuffed = -1.1;
        return {.angle = mixed(kLying, kPuffed, (pointer.x() - root.x()) / kRingPx)};
    }
    case model::ToolId::Scissors: {
        constexpr double kCut = 0.5;
        return {.lengthPx = pointer.x() > root.x() ? kHairPx * kCut : kHairPx};
    }
    case model::ToolId::Gradient: {
        const double along = (root.x() - moment.area.left()) / moment.area.width();
        return {.lengthPx = moment.done < 1.0 ? kHairPx : mixed(3.0, 1.5 * kHairPx, along)};
    }
    default:
        return {};
    }
}

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

bool ToolDemo::shows(model::ToolId tool)
{
    using model::ToolId;
    return tool == ToolId::Comb || tool == ToolId::Part || tool == ToolId::Grab || tool == ToolId::Fingers ||
           tool == ToolId::Scissors || tool == ToolId::Gradient;
}

void ToolDemo::setTool(model::ToolId tool)
{
    m_tool = tool;
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
    const Theme theme = Theme::current();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.window);
    painter.drawRoundedRect(QRectF(rect()), metrics::kRadius, metrics::kRadius);
    painter.setClipRect(rect());

    const QRectF area = QRectF(rect()).adjusted(14.0, kHairPx + 6.0, -14.0, -8.0);
    const Moment moment{area, std::clamp(m_play.currentValue().toDouble() / kStrokeFraction, 0.0, 1.0)};
    painter.setPen(QPen(theme.text, 1.6, Qt::SolidLine, Qt::RoundCap));
    for (int row = 0; row < kRows; ++row)
        for (int column = 0; column < kColumns; ++column) {
            const QPointF root(area.left() + area.width() * column / (kColumns - 1),
                               area.top() + area.height() * row / (kRows - 1));
            const DemoHair hair = hairOf(m_tool, moment, column, row, root);
            painter.drawLine(root,
                             root + QPointF(std::cos(hair.angle), std::sin(hair.angle)) * std::max(0.1, hair.lengthPx));
        }
    const QPointF pointer = pointerOf(m_tool, moment);
    painter.setPen(QPen(theme.accent, 2.0));
    painter.setBrush(Qt::NoBrush);
    if (m_tool == model::ToolId::Gradient || m_tool == model::ToolId::Part) {
        painter.drawLine(pointerOf(m_tool, {area, 0.0}), pointer);
        painter.setBrush(theme.accent);
        painter.drawEllipse(pointer, 3.0, 3.0);
    } else {
        painter.drawEllipse(pointer, kRingPx, kRingPx);
    }
}

} // namespace hairpaint::view
