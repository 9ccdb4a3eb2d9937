// Rings and outlines, and the timers that move them.
#include "view/paint_area/paint_overlay.h"

#include "view/editing/editor_state.h"
#include "view/editing/painted_area.h"
#include "view/paint_area/skin_ring.h"

#include <QPainter>
#include <QTimerEvent>
#include <QWidget>

#include <algorithm>
#include <utility>

namespace hairpaint::view {

namespace {

constexpr int kMarchMs = 120;
constexpr int kMarchSteps = 8;
constexpr int kRingMarginPx = 4;
constexpr int kFlashMs = 900;

QRect boundsOf(const std::vector<QPolygonF>& polygons)
{
    QRectF bounds;
    for (const QPolygonF& polygon : polygons)
        bounds |= polygon.boundingRect();
    return bounds.isNull()
               ? QRect()
               : bounds.toAlignedRect().adjusted(-kRingMarginPx, -kRingMarginPx, kRingMarginPx, kRingMarginPx);
}

QPolygonF onWidget(const QPolygonF& uvPolygon, const QTransform& paperToWidget)
{
    QPolygonF polygon;
    polygon.reserve(uvPolygon.size());
    for (const QPointF& uv : uvPolygon)
        polygon.push_back(paperToWidget.map(QPointF(uv.x(), 1.0 - uv.y())));
    return polygon;
}

} // namespace

PaintOverlay::PaintOverlay(EditorState& editor, const UvTransform& transform, QWidget& area)
    : m_editor(editor), m_transform(transform), m_area(area)
{}

void PaintOverlay::refreshRings()
{
    const float radiusM = m_editor.tools().settings().brushSizeM / 2.0F;
    const QTransform toWidget = m_transform.paperToWidget();
    m_area.update(m_ringsBounds);
    m_rings.clear();
    for (const sim::SurfacePoint& point : m_editor.hover().ringPoints())
        m_rings.push_back(onWidget(ringOnUv(point, radiusM), toWidget));
    m_ringsBounds = boundsOf(m_rings);
    m_area.update(m_ringsBounds);
}

void PaintOverlay::refreshOutlines()
{
    m_outlines = m_editor.tools().overlay();
    if (!m_flashed.isEmpty())
        m_outlines.push_back({.uvOutline = m_flashed, .closed = true});
    std::vector<QPolygonF> outlines;
    const QTransform toWidget = m_transform.paperToWidget();
    for (const model::OverlayShape& shape : m_outlines) {
        outlines.push_back(onWidget(shape.uvOutline, toWidget));
        for (const QPointF& handle : onWidget(shape.uvHandles, toWidget))
            outlines.emplace_back(handleAt(handle));
    }
    m_area.update(m_outlinesBounds);
    m_outlinesBounds = boundsOf(outlines);
    m_area.update(m_outlinesBounds);
    const bool marches = std::ranges::any_of(m_outlines, &model::OverlayShape::marching);
    if (marches && !m_marching.isActive())
        m_marching.start(kMarchMs, this);
    else if (!marches)
        m_marching.stop();
}

void PaintOverlay::flash(QPolygonF uvOutline)
{
    m_flashed = std::move(uvOutline);
    if (m_flashed.isEmpty())
        m_flash.stop();
    else
        m_flash.start(kFlashMs, this);
    refreshOutlines();
}

void PaintOverlay::timerEvent(QTimerEvent* event)
{
    if (event->timerId() == m_flash.timerId())
        flash({});
    else if (event->timerId() == m_marching.timerId())
        march();
    else
        QObject::timerEvent(event);
}

void PaintOverlay::march()
{
    m_marchStep = (m_marchStep + 1) % kMarchSteps;
    // Only the outline's own pixels, so that a large selection costs little.
    const QTransform toWidget = m_transform.paperToWidget();
    QRegion dirty;
    for (const model::OverlayShape& shape : m_outlines) {
        const QPolygonF outline = onWidget(shape.uvOutline, toWidget);
        for (qsizetype i = 0; shape.marching && outline.size() <= 8 && i < outline.size(); ++i) {
            const QRectF side = QRectF(outline[i], outline[(i + 1) % outline.size()]).normalized();
            dirty += side.toAlignedRect().adjusted(-2, -2, 2, 2);
        }
        if (shape.marching && outline.size() > 8)
            dirty += outline.boundingRect().toAlignedRect().adjusted(-2, -2, 2, 2);
    }
    m_area.update(dirty);
}

void PaintOverlay::paint(QPainter& painter) const
{
    paintOutlines(painter);
    paintRings(painter);
}

void PaintOverlay::paintOutlines(QPainter& painter) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    const QTransform toWidget = m_transform.paperToWidget();
    for (const model::OverlayShape& shape : m_outlines) {
        const QPolygonF outline = onWidget(shape.uvOutline, toWidget);
        const auto draw = [&](const QPen& pen) {
            painter.setPen(pen);
            if (shape.closed)
                painter.drawPolygon(outline);
            else
                painter.drawPolyline(outline);
        };
        QPen dark(QColor(0, 0, 0, 190), shape.marching ? 1.0 : 3.0);
        QPen light(QColor(255, 255, 255, shape.marching ? 255 : 235), shape.marching ? 1.0 : 1.5);
        if (shape.marching) {
            light.setDashPattern({4.0, 4.0});
            light.setDashOffset(m_marchStep);
            light.setCapStyle(Qt::FlatCap);
        }
        draw(dark);
        draw(light);
        painter.setPen(QPen(QColor(0, 0, 0, 190), 1.0));
        painter.setBrush(QColor(255, 255, 255, 235));
        for (const QPointF& handle : onWidget(shape.uvHandles, toWidget))
            painter.drawRect(handleAt(handle));
        painter.setBrush(Qt::NoBrush);
    }
}

void PaintOverlay::paintRings(QPainter& painter) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    bool twin = false;
    for (const QPolygonF& ring : m_rings) {
        painter.setPen(QPen(QColor(0, 0, 0, 150), 3.0));
        painter.drawPolygon(ring);
        painter.setPen(QPen(twin ? QColor(255, 255, 255, 150) : QColor(255, 255, 255, 235), 1.4));
        painter.drawPolygon(ring);
        const QRectF bounds = ring.boundingRect();
        if (!twin) {
            // The middle, so that a ring of a few pixels is still found.
            painter.setPen(Qt::NoPen);
            painter.setBrush(QColor(0, 0, 0, 150));
            painter.drawEllipse(bounds.center(), 2.0, 2.0);
            painter.setBrush(QColor(255, 255, 255, 235));
            painter.drawEllipse(bounds.center(), 1.2, 1.2);
            painter.setBrush(Qt::NoBrush);
        }
        twin = true;
    }
}

} // namespace hairpaint::view
