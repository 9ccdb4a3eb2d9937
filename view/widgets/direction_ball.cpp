// A ball whose handle is a direction.
#include "view/widgets/direction_ball.h"

#include "view/look/icons.h"
#include "view/look/theme.h"
#include "view/widgets/colour_math.h"

#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hairpaint::view {

namespace {

constexpr double kStepRad = 5.0 * std::numbers::pi / 180.0;
constexpr double kHandle = 7.0;

} // namespace

DirectionBall::DirectionBall(Meaning meaning, QWidget* parent) : QWidget(parent), m_meaning(meaning)
{
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::CrossCursor);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setAccessibleName(meaning == Meaning::From ? tr("Where the light comes from") : tr("Where the wind blows to"));
    setToolTip(tr("Drag to turn; double-click for the other half (front or back); arrows for small steps"));
    describe();
}

glm::vec3 DirectionBall::fromAngles(double azimuthRad, double elevationRad)
{
    return {static_cast<float>(std::sin(azimuthRad) * std::cos(elevationRad)),
            static_cast<float>(std::sin(elevationRad)),
            static_cast<float>(std::cos(azimuthRad) * std::cos(elevationRad))};
}

double DirectionBall::azimuthRad(glm::vec3 direction)
{
    return std::atan2(static_cast<double>(direction.x), static_cast<double>(direction.z));
}

double DirectionBall::elevationRad(glm::vec3 direction)
{
    return std::asin(std::clamp(static_cast<double>(direction.y), -1.0, 1.0));
}

void DirectionBall::setDirection(glm::vec3 direction)
{
    if (m_editing || direction == m_direction)
        return;
    m_direction = direction;
    describe();
    update();
}

void DirectionBall::describe()
{
    const auto degrees = [](double rad) { return QLocale().toString(qRound(rad * 180.0 / std::numbers::pi)); };
    setAccessibleDescription(
        tr("%1° around, %2° up").arg(degrees(azimuthRad(m_direction)), degrees(elevationRad(m_direction))));
}

QRectF DirectionBall::circle() const
{
    const double side = std::min(width(), height()) - 2.0 * kHandle - 2.0;
    return {(width() - side) / 2.0, (height() - side) / 2.0, side, side};
}

glm::vec3 DirectionBall::at(QPointF position) const
{
    const QRectF ball = circle();
    double x = (position.x() - ball.center().x()) / (ball.width() / 2.0);
    double y = (ball.center().y() - position.y()) / (ball.height() / 2.0);
    const double length = std::hypot(x, y);
    if (length > 1.0) {
        x /= length;
        y /= length;
    }
    const double z = std::sqrt(std::max(0.0, 1.0 - x * x - y * y));
    return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(m_direction.z < 0.0F ? -z : z)};
}

void DirectionBall::begin()
{
    if (m_editing)
        return;
    m_editing = true;
    m_before = m_direction;
}

void DirectionBall::moveTo(glm::vec3 direction)
{
    if (direction == m_direction)
        return;
    m_direction = direction;
    describe();
    update();
    Q_EMIT changed(m_direction);
}

void DirectionBall::finish()
{
    if (!m_editing)
        return;
    m_editing = false;
    m_dragging = false;
    if (m_direction == m_before)
        Q_EMIT cancelled();
    else
        Q_EMIT finished(m_direction);
}

void DirectionBall::cancel()
{
    if (!m_editing)
        return;
    m_direction = m_before;
    m_editing = false;
    m_dragging = false;
    describe();
    update();
    Q_EMIT cancelled();
}

void DirectionBall::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::RightButton) {
        cancel();
        return;
    }
    if (event->button() != Qt::LeftButton)
        return;
    begin();
    m_dragging = true;
    moveTo(at(event->position()));
}

void DirectionBall::mouseMoveEvent(QMouseEvent* event)
{
    if (m_dragging)
        moveTo(at(event->position()));
}

void DirectionBall::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton && m_dragging)
        finish();
}

void DirectionBall::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton)
        return;
    begin();
    moveTo({m_direction.x, m_direction.y, -m_direction.z});
    finish();
}

void DirectionBall::keyPressEvent(QKeyEvent* event)
{
    double azimuth = azimuthRad(m_direction);
    double elevation = elevationRad(m_direction);
    switch (event->key()) {
    case Qt::Key_Left:
        azimuth -= kStepRad;
        break;
    case Qt::Key_Right:
        azimuth += kStepRad;
        break;
    case Qt::Key_Up:
        elevation += kStepRad;
        break;
    case Qt::Key_Down:
        elevation -= kStepRad;
        break;
    case Qt::Key_Escape:
        if (m_editing) {
            cancel();
            return;
        }
        [[fallthrough]];
    default:
        QWidget::keyPressEvent(event);
        return;
    }
    begin();
    // Straight up and down have no azimuth to come back by.
    constexpr double kSteepest = 89.0 * std::numbers::pi / 180.0;
    moveTo(fromAngles(azimuth, std::clamp(elevation, -kSteepest, kSteepest)));
}

void DirectionBall::keyReleaseEvent(QKeyEvent* event)
{
    const bool arrow = event->key() >= Qt::Key_Left && event->key() <= Qt::Key_Down;
    if (arrow && !event->isAutoRepeat() && !m_dragging)
        finish();
    else
        QWidget::keyReleaseEvent(event);
}

void DirectionBall::focusOutEvent(QFocusEvent* event)
{
    finish();
    update();
    QWidget::focusOutEvent(event);
}

void DirectionBall::paintEvent(QPaintEvent* /*event*/)
{
    const Theme theme = Theme::current();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF ball = circle();
    const QPointF middle = ball.center();
    const double radius = ball.width() / 2.0;
    const QPointF handle(middle.x() + static_cast<double>(m_direction.x) * radius,
                         middle.y() - static_cast<double>(m_direction.y) * radius);
    const bool front = m_direction.z >= 0.0F;
    const QColor ink = isEnabled() ? theme.text : theme.dimText;
    const QColor mark = isEnabled() ? theme.accent : theme.dimText;

    QRadialGradient shade(m_meaning == Meaning::From && front ? handle : middle, radius * 1.5);
    const bool lamp = m_meaning == Meaning::From;
    const bool dark = theme.kind == ThemeKind::Dark;
    const QColor lit = dark ? mixed(theme.raised, theme.text, lamp && front ? 0.34 : 0.10) : QColor(Qt::white);
    shade.setColorAt(0.0, lit);
    shade.setColorAt(1.0, dark ? theme.raised : mixed(theme.raised, theme.line, lamp && front ? 1.0 : 0.5));
    painter.setBrush(shade);
    painter.setPen(QPen(hasFocus() ? theme.accent : theme.line, hasFocus() ? 2.0 : 1.0));
    painter.drawEllipse(ball);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(mixed(theme.raised, theme.dimText, 0.45), 1.0));
    for (const double fraction : {0.0, 0.5}) {
        painter.drawEllipse(middle, radius * fraction, radius);
        painter.drawEllipse(middle, radius, radius * fraction);
    }
    // A head's outline tells where the front is.
    painter.setPen(QPen(mixed(theme.raised, ink, 0.7), 1.5));
    painter.setBrush(mixed(theme.raised, theme.panel, 0.6));
    painter.drawEllipse(middle, radius * 0.20, radius * 0.26);
    QPainterPath nose;
    nose.moveTo(middle.x(), middle.y() - radius * 0.03);
    nose.lineTo(middle.x() - radius * 0.045, middle.y() + radius * 0.08);
    nose.lineTo(middle.x() + radius * 0.02, middle.y() + radius * 0.08);
    painter.drawPath(nose);

    painter.setPen(QPen(mark, 2.0, front ? Qt::SolidLine : Qt::DotLine, Qt::RoundCap));
    const QPointF along = handle - middle;
    const double length = std::hypot(along.x(), along.y());
    if (length > kHandle + radius * 0.28)
        painter.drawLine(middle + along * (radius * 0.30 / length), handle - along * (kHandle / length));
    painter.setPen(QPen(mark, 2.0));
    painter.setBrush(front ? mark : theme.panel);
    painter.drawEllipse(handle, kHandle, kHandle);
    if (m_meaning == Meaning::Toward && length > kHandle) {
        painter.save();
        painter.translate(handle);
        painter.rotate(std::atan2(along.y(), along.x()) * 180.0 / std::numbers::pi);
        painter.setPen(QPen(front ? theme.onAccent : mark, 1.75, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolyline(QPolygonF{QPointF(-1.5, -3.0), QPointF(2.0, 0.0), QPointF(-1.5, 3.0)});
        painter.restore();
    }
}

} // namespace hairpaint::view
