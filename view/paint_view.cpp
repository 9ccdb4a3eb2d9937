// The paint area's look and its following of the document.
#include "view/paint_view.h"

#include "view/paint/paint_view_state.h"
#include "view/paint/skin_ring.h"

#include <QPaintEvent>
#include <QPainter>
#include <QTimerEvent>

#include <algorithm>
#include <cmath>

namespace hairpaint::view {

namespace {

constexpr int kMarchMs = 120;
constexpr int kMarchSteps = 8;
constexpr int kRingMarginPx = 4;
constexpr int kOutlineMs = 900;

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

/// Around all tiles that a change touched, in uv; empty where it names none.
QPolygonF outlineOf(const model::Change& change, const model::Document& document)
{
    QRectF bounds;
    if (change.aspect == model::Change::Aspect::Texels) {
        const std::shared_ptr<const sim::TiledRaster> raster = document.resolved(change.group, change.map);
        for (const int tile : raster != nullptr ? change.tiles : std::vector<int>())
            bounds |= paperRect(raster->tileRect(tile), raster->size());
    }
    if (bounds.isEmpty())
        return {};
    QPolygonF outline(bounds);
    for (QPointF& corner : outline)
        corner.setY(1.0 - corner.y());
    return outline;
}

} // namespace

PaintView::PaintView(EditorState& state, const Theme& theme, StartBackdrop start, QWidget* parent)
    : PaintedArea(state, parent), m_state(std::make_unique<State>(state, theme, std::move(start), this))
{
    setObjectName(QStringLiteral("paintArea"));
    setAttribute(Qt::WA_OpaquePaintEvent);
    setMinimumSize(160, 160);
    m_state->legend = new MapLegend(this);
    connect(&state.document(), &model::Document::changed, this, &PaintView::onDocumentChanged);
    connect(&state.document(), &model::Document::undone, this, &PaintView::showChangedOutline);
    connect(&state.document(), &model::Document::redone, this, &PaintView::showChangedOutline);
    connect(&state, &EditorState::targetChanged, this, &PaintView::refreshMap);
    connect(&state, &EditorState::viewOptionsChanged, this, [this] {
        lookChanged();
        refreshMap();
        refreshHover();
    });
    connect(&state, &EditorState::activeToolChanged, this, [this] {
        refreshHover();
        refreshOverlay();
        updateCursor();
    });
    connect(&state, &EditorState::toolSettingsChanged, this, &PaintView::refreshHover);
    connect(&state, &EditorState::hoverChanged, this, &PaintView::refreshHover);
    connect(&state, &EditorState::overlayChanged, this, &PaintView::refreshOverlay);
    connect(&m_state->keys, &HeldKeys::changed, this, &PaintView::updateCursor);
    refreshHead();
    refreshMap();
    updateCursor();
}

PaintView::~PaintView() = default;

QSize PaintView::sizeHint() const
{
    return {560, 560};
}

void PaintView::setTheme(const Theme& theme)
{
    m_state->theme = theme;
    lookChanged();
}

glm::vec2 PaintView::uvAt(QPointF position) const
{
    return m_state->transform.toUv(position);
}

QPointF PaintView::positionOf(glm::vec2 uv) const
{
    return m_state->transform.toWidget(uv);
}

double PaintView::zoom() const
{
    return m_state->transform.pxPerPaper / m_state->transform.fittingPx();
}

bool PaintView::mirrored() const
{
    return m_state->transform.mirrored;
}

double PaintView::rotationDeg() const
{
    return m_state->transform.rotationDeg;
}

void PaintView::onDocumentChanged(const model::Change& change)
{
    using Aspect = model::Change::Aspect;
    if (!change.preview)
        m_state->changedOutline = outlineOf(change, m_state->editor.document());
    if (change.aspect == Aspect::Head || change.aspect == Aspect::Everything)
        refreshHead();
    if (change.aspect != Aspect::Environment)
        refreshMap();
}

void PaintView::showChangedOutline()
{
    m_state->shownOutline = m_state->changedOutline;
    m_state->outlined.start(kOutlineMs, this);
    refreshOverlay();
}

void PaintView::refreshHead()
{
    const std::shared_ptr<const model::Head>& head = m_state->editor.document().project().head;
    if (head == m_state->head)
        return lookChanged();
    m_state->head = head;
    const bool known = head && head->skin;
    m_state->canvas.setLandmarks(known ? landmarksOf(*head) : std::vector<Landmark>());
    m_state->canvas.setBackdrop(nullptr); // Rather none than another head's.
    lookChanged();
    if (!known)
        return;
    const auto make = [head] { return makeHeadBackdrop(*head); };
    const auto show = [this, head](const BackdropPtr& backdrop) {
        if (head != m_state->head)
            return; // A newer one has come meanwhile.
        m_state->canvas.setBackdrop(backdrop);
        lookChanged();
    };
    if (m_state->startBackdrop)
        m_state->startBackdrop(make, this, show);
    else
        show(make());
}

void PaintView::refreshMap()
{
    const EditorState& editor = m_state->editor;
    const model::MapSpec& spec = model::mapSpec(editor.activeMap());
    const bool exists = editor.document().project().group(editor.activeGroup()) != nullptr;
    const QList<QRectF> changed =
        m_state->canvas.setMap(exists ? editor.document().resolved(editor.activeGroup(), editor.activeMap()) : nullptr,
                               spec, editor.nightPaper());
    const QTransform toWidget = m_state->transform.paperToWidget();
    QRegion dirty;
    for (const QRectF& part : changed)
        dirty += toWidget.mapRect(part).toAlignedRect().adjusted(-2, -2, 2, 2);
    update(dirty);
    refreshLegend();
}

void PaintView::refreshLegend()
{
    const EditorState& editor = m_state->editor;
    const model::MapSpec& spec = model::mapSpec(editor.activeMap());
    const model::HairGroup* group = editor.document().project().group(editor.activeGroup());
    if (group == nullptr || spec.texel == model::TexelKind::Colour)
        m_state->legend->hide();
    else
        m_state->legend->showMap(spec, group->settings, editor.nightPaper());
}

void PaintView::refreshHover()
{
    std::vector<QPolygonF> rings;
    const EditorState& editor = m_state->editor;
    if (const std::optional<Hover>& hover = editor.hover(); hover && hover->point && editor.activeTool().hasRing()) {
        const float radiusM = editor.toolSettings().brushSizeM / 2.0F;
        const QTransform toWidget = m_state->transform.paperToWidget();
        rings.push_back(onWidget(ringOnUv(*hover->point, radiusM), toWidget));
        const std::shared_ptr<const model::Head>& head = editor.document().project().head;
        if (editor.mirror() && head && head->skin) {
            if (const std::optional<sim::SurfacePoint> twin = head->skin->mirrored(*hover->point))
                rings.push_back(onWidget(ringOnUv(*twin, radiusM), toWidget));
        }
    }
    update(m_state->ringsBounds);
    m_state->rings = std::move(rings);
    m_state->ringsBounds = boundsOf(m_state->rings);
    update(m_state->ringsBounds);
    updateCursor();
}

void PaintView::refreshOverlay()
{
    State& state = *m_state;
    state.overlay = state.editor.activeTool().overlay();
    for (QPolygonF& outline : state.editor.selection().outlines())
        state.overlay.push_back({.uvOutline = std::move(outline), .closed = true, .marching = true});
    if (!state.shownOutline.isEmpty())
        state.overlay.push_back({.uvOutline = state.shownOutline, .closed = true});
    std::vector<QPolygonF> outlines;
    const QTransform toWidget = state.transform.paperToWidget();
    for (const model::OverlayShape& shape : state.overlay)
        outlines.push_back(onWidget(shape.uvOutline, toWidget));
    update(state.overlayBounds);
    state.overlayBounds = boundsOf(outlines);
    update(state.overlayBounds);
    const bool marches = std::ranges::any_of(state.overlay, &model::OverlayShape::marching);
    if (marches && !state.march.isActive())
        state.march.start(kMarchMs, this);
    else if (!marches)
        state.march.stop();
}

void PaintView::timerEvent(QTimerEvent* event)
{
    if (event->timerId() == m_state->outlined.timerId()) {
        m_state->outlined.stop();
        m_state->shownOutline.clear();
        refreshOverlay();
        return;
    }
    if (event->timerId() != m_state->march.timerId()) {
        QWidget::timerEvent(event);
        return;
    }
    m_state->marchStep = (m_state->marchStep + 1) % kMarchSteps;
    // Only the outline's own pixels, so that a large selection costs little.
    const QTransform toWidget = m_state->transform.paperToWidget();
    QRegion dirty;
    for (const model::OverlayShape& shape : m_state->overlay) {
        const QPolygonF outline = onWidget(shape.uvOutline, toWidget);
        for (qsizetype i = 0; shape.marching && outline.size() <= 8 && i < outline.size(); ++i) {
            const QRectF side = QRectF(outline[i], outline[(i + 1) % outline.size()]).normalized();
            dirty += side.toAlignedRect().adjusted(-2, -2, 2, 2);
        }
        if (shape.marching && outline.size() > 8)
            dirty += outline.boundingRect().toAlignedRect().adjusted(-2, -2, 2, 2);
    }
    update(dirty);
}

void PaintView::lookChanged()
{
    m_state->canvas.invalidate();
    refreshHover();
    refreshOverlay();
    update();
}

void PaintView::paintEvent(QPaintEvent* event)
{
    QPainter painter(this);
    const PaintCanvas::Look look{.transform = m_state->transform,
                                 .devicePixelRatio = devicePixelRatioF(),
                                 .nightPaper = m_state->editor.nightPaper(),
                                 .wireframe = m_state->editor.wireframe(),
                                 .theme = m_state->theme,
                                 .font = font()};
    for (const QRect& dirty : event->region()) {
        painter.setClipRect(dirty);
        m_state->canvas.paint(painter, dirty, look);
    }
    painter.setClipRegion(event->region());
    paintOverlay(painter);
    paintRings(painter);
}

void PaintView::paintOverlay(QPainter& painter) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    const QTransform toWidget = m_state->transform.paperToWidget();
    for (const model::OverlayShape& shape : m_state->overlay) {
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
            light.setDashOffset(m_state->marchStep);
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

void PaintView::paintRings(QPainter& painter) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    bool twin = false;
    for (const QPolygonF& ring : m_state->rings) {
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

void PaintView::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    m_state->transform.widget = QSizeF(size());
    m_state->legend->place();
    if (m_state->fitted)
        m_state->transform.fit(QRectF(0.0, 0.0, 1.0, 1.0));
    lookChanged();
}

} // namespace hairpaint::view
