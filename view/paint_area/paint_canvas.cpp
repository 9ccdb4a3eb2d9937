// The layers of the paint area.
#include "view/paint_area/paint_canvas.h"

#include "view/paint_area/field_hairs.h"
#include "view/paint_area/uv_shading.h"

#include <cmath>

namespace hairpaint::view {

namespace {

/// Least and greatest size of the map at which landmarks are named.
constexpr double kLeastLabelledPx = 320.0;
constexpr double kMostLabelledPx = 6000.0;

QRectF visiblePaper(const UvTransform& transform, const QRectF& widgetRect)
{
    return transform.paperToWidget().inverted().mapRect(widgetRect);
}

} // namespace

void PaintCanvas::setLandmarks(std::vector<Landmark> landmarks)
{
    m_landmarks = std::move(landmarks);
    m_upperValid = false;
}

void PaintCanvas::setBackdrop(BackdropPtr backdrop)
{
    m_backdrop = std::move(backdrop);
    m_veil = QImage();
    m_upperValid = false;
}

QList<QRectF> PaintCanvas::setMap(std::shared_ptr<const sim::TiledRaster> raster, const model::MapSpec& spec,
                                  bool nightPaper)
{
    m_isField = raster != nullptr && spec.texel == model::TexelKind::Vector;
    return m_pyramid.setSource(std::move(raster), spec, nightPaper);
}

int PaintCanvas::reachPx() const
{
    constexpr int kSmooth = 2; ///< Reach of the smoothing where the picture is drawn smaller.
    return m_isField ? kFieldHairReachPx : kSmooth;
}

void PaintCanvas::invalidate()
{
    m_upperValid = false;
}

void PaintCanvas::paint(QPainter& painter, const QRect& dirty, const Look& look)
{
    painter.fillRect(dirty, look.theme.window);
    const QTransform toWidget = look.transform.paperToWidget();
    m_pyramid.draw(painter, toWidget, visiblePaper(look.transform, dirty), look.devicePixelRatio);
    if (m_isField)
        drawFieldHairs(painter, dirty, look.transform, *m_pyramid.raster(),
                       m_backdrop ? m_backdrop->shading : QImage());
    drawUpper(look);
    const double ratio = look.devicePixelRatio;
    painter.drawImage(QRectF(dirty), m_upper,
                      QRectF(dirty.x() * ratio, dirty.y() * ratio, dirty.width() * ratio, dirty.height() * ratio));
}

void PaintCanvas::drawUpper(const Look& look)
{
    const QSize size = (look.transform.widget * look.devicePixelRatio).toSize();
    if (m_upperValid && m_upper.size() == size)
        return;
    if (m_upper.size() != size)
        m_upper = QImage(size, QImage::Format_ARGB32_Premultiplied);
    m_upper.setDevicePixelRatio(look.devicePixelRatio);
    m_upper.fill(Qt::transparent);
    m_upperValid = true;

    const QColor outside = look.theme.window;
    if (m_backdrop && (m_veil.isNull() || m_veilIsNight != look.nightPaper || m_veilOutside != outside)) {
        m_veil = shadingVeil(m_backdrop->shading, look.nightPaper, outside);
        m_veilIsNight = look.nightPaper;
        m_veilOutside = outside;
    }
    QPainter painter(&m_upper);
    const QTransform toWidget = look.transform.paperToWidget();
    if (!m_veil.isNull()) {
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.setTransform(toWidget);
        painter.drawImage(QRectF(0.0, 0.0, 1.0, 1.0), m_veil);
        painter.resetTransform();
    }
    if (look.wireframe && m_backdrop)
        painter.drawImage(QPointF(), wireframePicture(look, size));
    painter.setPen(QPen(look.theme.line, 1.0));
    painter.setRenderHint(QPainter::Antialiasing);
    painter.drawPolygon(toWidget.map(QPolygonF(QRectF(0.0, 0.0, 1.0, 1.0))));
    drawLandmarks(painter, look);
}

QImage PaintCanvas::wireframePicture(const Look& look, QSize size)
{
    QImage lines(size, QImage::Format_Grayscale8);
    lines.setDevicePixelRatio(look.devicePixelRatio);
    lines.fill(Qt::black);
    {
        // Fainter from afar, where many edges would make a fog.
        const double nearness = std::clamp(std::log2(look.transform.pxPerPaper / 400.0) / 4.0, 0.0, 1.0);
        QPainter painter(&lines);
        m_backdrop->wireframe.draw(painter, look.transform.paperToWidget(),
                                   visiblePaper(look.transform, QRectF(QPointF(), look.transform.widget)),
                                   static_cast<int>(30.0 + 34.0 * nearness), 110);
    }
    QImage ink(size, QImage::Format_ARGB32_Premultiplied);
    ink.setDevicePixelRatio(look.devicePixelRatio);
    ink.fill(look.nightPaper ? QColor(255, 255, 255) : QColor(20, 24, 30));
    lines.reinterpretAsFormat(QImage::Format_Alpha8);
    QPainter painter(&ink);
    painter.setCompositionMode(QPainter::CompositionMode_DestinationIn);
    painter.drawImage(QPointF(), lines);
    return ink;
}

void PaintCanvas::drawLandmarks(QPainter& painter, const Look& look) const
{
    if (look.transform.pxPerPaper < kLeastLabelledPx || look.transform.pxPerPaper > kMostLabelledPx)
        return;
    QFont font = look.font;
    font.setPixelSize(11);
    painter.setFont(font);
    const QFontMetricsF metrics(font);
    // On a ground of their own, so that they are read on every map's colours.
    const QColor text = look.nightPaper ? QColor(255, 255, 255, 225) : QColor(20, 24, 30, 235);
    const QColor ground = look.nightPaper ? QColor(0, 0, 0, 140) : QColor(255, 255, 255, 170);
    for (const Landmark& landmark : m_landmarks) {
        const QPointF at = look.transform.toWidget(landmark.uv);
        painter.setPen(Qt::NoPen);
        painter.setBrush(ground);
        painter.drawEllipse(at, 3.5, 3.5);
        painter.setBrush(text);
        painter.drawEllipse(at, 1.75, 1.75);
        const double width = metrics.horizontalAdvance(landmark.name) + 8.0;
        const QRectF label(at.x() - width / 2.0, at.y() + 6.0, width, metrics.height() + 1.0);
        painter.setBrush(ground);
        painter.drawRoundedRect(label, 4.0, 4.0);
        painter.setPen(text);
        painter.drawText(label, Qt::AlignCenter, landmark.name);
    }
}

} // namespace hairpaint::view
