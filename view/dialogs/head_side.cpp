// Picks and drags landmarks on a picture without perspective.
#include "view/dialogs/head_side.h"

#include "view/look/theme.h"
#include "view/paint_area/landmarks.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>

namespace hairpaint::view {

namespace {

constexpr double kDotPx = 6.0;
constexpr double kReachPx = 14.0; ///< A press that near takes hold of a landmark.

/// Columns: right, up, toward the eye. The head looks to +z; its left is at +x.
glm::mat3 sideAxes(rendering::StandardView side)
{
    using rendering::StandardView;
    constexpr glm::vec3 x(1.0F, 0.0F, 0.0F);
    constexpr glm::vec3 y(0.0F, 1.0F, 0.0F);
    constexpr glm::vec3 z(0.0F, 0.0F, 1.0F);
    switch (side) {
    case StandardView::Back:
        return {-x, y, -z};
    case StandardView::Left:
        return {-z, y, x};
    case StandardView::Right:
        return {z, y, -x};
    case StandardView::Top:
        return {x, -z, y};
    default:
        return {x, y, z};
    }
}

} // namespace

HeadSide::HeadSide(std::shared_ptr<const model::Head> head, const sim::HeadLandmarks& landmarks, QWidget* parent)
    : QWidget(parent), m_head(std::move(head)), m_landmarks(landmarks)
{
    constexpr float kMargin = 1.35F; // Hairstyles aside, a head ends a little beyond its landmarks.
    setMouseTracking(true);
    glm::vec3 low = landmarks.positionsHd.front();
    glm::vec3 high = low;
    for (const glm::vec3& position : landmarks.positionsHd) {
        low = glm::min(low, position);
        high = glm::max(high, position);
    }
    m_middleHd = 0.5F * (low + high);
    const glm::vec3 size = high - low;
    m_reachM = std::max(0.5F * kMargin * std::max({size.x, size.y, size.z}), 1e-3F);
}

void HeadSide::setSide(rendering::StandardView side)
{
    m_side = side;
    m_picture = {};
    update();
}

void HeadSide::setLandmarks(const sim::HeadLandmarks& landmarks)
{
    m_landmarks = landmarks;
    update();
}

MeshFraming HeadSide::framing(QSize pixels) const
{
    const glm::vec2 size(static_cast<float>(pixels.width()), static_cast<float>(pixels.height()));
    return {.axes = sideAxes(m_side),
            .middle = m_middleHd,
            .middlePx = 0.5F * size,
            .pixelsPerUnit = 0.5F * std::min(size.x, size.y) / m_reachM};
}

std::optional<QPointF> HeadSide::positionOf(sim::HeadLandmark landmark) const
{
    constexpr float kToleranceM = 0.004F; // A landmark in a fold still is to be seen.
    const MeshFraming frame = framing(size());
    const glm::vec3 positionHd = m_landmarks[landmark];
    const glm::vec3 px = frame.toPicture(positionHd);
    const QPointF position(static_cast<double>(px.x), static_cast<double>(px.y));
    const std::optional<sim::SurfacePoint> seen = m_head->skin->pick(frame.rayThrough(position));
    if (seen && glm::dot(seen->positionHd - positionHd, frame.axes[2]) > kToleranceM)
        return std::nullopt;
    return position;
}

std::optional<sim::HeadLandmark> HeadSide::landmarkAt(QPointF position) const
{
    std::optional<sim::HeadLandmark> nearest;
    double least = kReachPx;
    for (std::size_t i = 0; i < sim::kHeadLandmarkCount; ++i) {
        const auto landmark = static_cast<sim::HeadLandmark>(i);
        const std::optional<QPointF> at = positionOf(landmark);
        const double distance = at ? QLineF(*at, position).length() : kReachPx;
        if (distance >= least)
            continue;
        least = distance;
        nearest = landmark;
    }
    return nearest;
}

void HeadSide::mousePressEvent(QMouseEvent* event)
{
    m_dragged = m_movable && event->button() == Qt::LeftButton ? landmarkAt(event->position()) : std::nullopt;
    if (m_dragged)
        m_grip = *positionOf(*m_dragged) - event->position();
}

void HeadSide::mouseMoveEvent(QMouseEvent* event)
{
    if (!m_dragged) {
        setCursor(m_movable && landmarkAt(event->position()) ? Qt::OpenHandCursor : Qt::ArrowCursor);
        return;
    }
    setCursor(Qt::ClosedHandCursor);
    // Beside the head it stays where it was.
    const auto point = m_head->skin->pick(framing(size()).rayThrough(event->position() + m_grip));
    if (!point)
        return;
    m_landmarks[*m_dragged] = point->positionHd;
    update();
    Q_EMIT landmarkMoved();
}

void HeadSide::mouseReleaseEvent(QMouseEvent* /*event*/)
{
    m_dragged.reset();
    setCursor(Qt::ArrowCursor);
}

void HeadSide::drawLandmark(QPainter& painter, sim::HeadLandmark landmark) const
{
    constexpr int kLabelGap = 10;
    const std::optional<QPointF> at = positionOf(landmark);
    if (!at)
        return;
    const Theme theme = Theme::current();
    painter.setPen(QPen(theme.window, 2.0));
    painter.setBrush(m_movable ? theme.accent : theme.text);
    painter.drawEllipse(*at, kDotPx, kDotPx);
    const QString name = landmarkName(landmark);
    const QFontMetrics metrics = painter.fontMetrics();
    QRectF label(0.0, 0.0, metrics.horizontalAdvance(name) + 8.0, metrics.height() + 2.0);
    label.moveCenter(*at);
    // Away from the middle, so that the dots of a profile stay free.
    label.moveLeft(at->x() > width() / 2.0 ? at->x() + kLabelGap : at->x() - kLabelGap - label.width());
    label.moveLeft(std::clamp(label.left(), 2.0, std::max(width() - label.width() - 2.0, 2.0)));
    QColor paper = theme.panel;
    paper.setAlphaF(0.8F);
    painter.setPen(Qt::NoPen);
    painter.setBrush(paper);
    painter.drawRoundedRect(label, metrics::kRadius, metrics::kRadius);
    painter.setPen(theme.text);
    painter.drawText(label, Qt::AlignCenter, name);
}

void HeadSide::paintEvent(QPaintEvent* /*event*/)
{
    const Theme theme = Theme::current();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(themeFont(TextRole::Label));
    painter.setPen(QPen(theme.line, 1.0));
    painter.setBrush(theme.window);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), metrics::kRadius, metrics::kRadius);
    const QSize pixels = size() * devicePixelRatioF();
    if (m_picture.size() != pixels)
        m_picture = meshPicture(m_head->skin->mesh(), framing(pixels), pixels);
    painter.drawImage(QRectF(rect()), m_picture);
    for (std::size_t i = 0; i < sim::kHeadLandmarkCount; ++i)
        drawLandmark(painter, static_cast<sim::HeadLandmark>(i));
}

} // namespace hairpaint::view
