// Lines over two pictures of the head.
#include "view/dialogs/hair_on_head.h"

#include "view/look/theme.h"

#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <cmath>

namespace hairpaint::view {

namespace {

/// Columns: to the picture's right, up, toward the eye. The face looks along +z, the head's left is +x.
const std::array<glm::mat3, 2> kSeenFrom{glm::mat3(1.0F),
                                         glm::mat3({0.0F, 0.0F, -1.0F}, {0.0F, 1.0F, 0.0F}, {1.0F, 0.0F, 0.0F})};
constexpr float kHeadPart = 0.8F; ///< So that hair which stands or hangs has room.
constexpr std::size_t kMostPoints = 24;

} // namespace

HairOnHead::HairOnHead(const sim::HeadMesh& head, const model::ForeignCurves& curves, QWidget* parent)
    : QWidget(parent), m_head(head), m_curves(curves)
{
    setAccessibleName(tr("The hair on the head, from the front and from its left"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void HairOnHead::setTransform(const model::CurveTransform& transform)
{
    m_transform = transform;
    update();
}

void HairOnHead::paintStrands(QPainter& painter, const MeshFraming& framing, bool isNear) const
{
    // What lies far outside is not handed to the painter, whose arithmetic ends before that of floats.
    const auto bound = [](float px) { return static_cast<double>(std::clamp(px, -1e5F, 1e5F)); };
    for (const model::ForeignStrands& group : m_curves.groups)
        for (std::size_t i = 0; i < group.count(); ++i) {
            const std::span<const glm::vec3> points = group.strand(i);
            if ((framing.toPicture(m_transform.toHd(points.front())).z >= 0.0F) != isNear)
                continue;
            const std::size_t steps = std::min(points.size(), kMostPoints) - 1;
            QPolygonF line;
            for (std::size_t step = 0; step <= steps; ++step) {
                const glm::vec3 px = framing.toPicture(m_transform.toHd(points[step * (points.size() - 1) / steps]));
                line << QPointF(bound(px.x), bound(px.y));
            }
            painter.drawPolyline(line);
        }
}

void HairOnHead::paintSide(QPainter& painter, const Side& side) const
{
    QColor colour = Theme::current().accent;
    painter.setPen(QPen(colour.darker(150), 1.0 * devicePixelRatioF()));
    paintStrands(painter, side.framing, false);
    painter.drawImage(QPointF(), side.head);
    colour.setAlphaF(0.7F);
    painter.setPen(QPen(colour, 1.0 * devicePixelRatioF()));
    paintStrands(painter, side.framing, true);
}

void HairOnHead::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    paintPicturePanel(painter, rect());
    painter.setBrush(Qt::NoBrush);
    const double ratio = devicePixelRatioF();
    const QRectF inner = QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0);
    const QSize pixels(static_cast<int>(inner.width() / 2.0 * ratio), static_cast<int>(inner.height() * ratio));
    for (std::size_t i = 0; i < m_sides.size(); ++i) {
        Side& side = m_sides.at(i);
        if (side.head.size() != pixels) {
            side.framing = MeshFraming::around(m_head, kSeenFrom.at(i), pixels);
            side.framing.pixelsPerUnit *= kHeadPart;
            side.head = meshPicture(m_head, side.framing, pixels);
        }
        painter.save();
        painter.translate(inner.left() + static_cast<double>(i) * inner.width() / 2.0, inner.top());
        painter.setClipRect(QRectF(0.0, 0.0, inner.width() / 2.0, inner.height()));
        painter.scale(1.0 / ratio, 1.0 / ratio);
        paintSide(painter, side);
        painter.restore();
    }
}

} // namespace hairpaint::view
