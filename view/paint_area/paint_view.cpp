// The paint area: its view of the map, and its following of the document.
#include "view/paint_area/paint_view.h"

#include "view/editing/editor_state.h"
#include "view/paint_area/map_legend.h"
#include "view/paint_area/paint_canvas.h"
#include "view/paint_area/paint_overlay.h"
#include "view/paint_area/paint_pointer.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QPaintEvent>
#include <QPainter>
#include <QTimer>
#include <QWheelEvent>

#include <cmath>
#include <utility>

namespace hairpaint::view {

namespace {

constexpr double kZoomPerNotch = 1.2;
constexpr double kWheelNotch = 120.0;
constexpr double kRefineMs = 4.0; ///< Time for refining in a frame, which has sixteen.
constexpr int kRestMs = 80;

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

/// What the area remembers between events.
struct PaintView::State
{
    State(EditorState& editorState, const Theme& startTheme, StartBackdrop start, QWidget* area)
        : editor(editorState), theme(startTheme), startBackdrop(std::move(start)),
          overlay(editorState, transform, *area), pointer(editorState, transform, overlay, *area)
    {}

    EditorState& editor;
    Theme theme;
    StartBackdrop startBackdrop;
    std::shared_ptr<const model::Head> head; ///< The head whose backdrop is shown or being made.
    PaintCanvas canvas;
    MapLegend* legend = nullptr; ///< A child.
    UvTransform transform;
    bool fitted = true; ///< The user has not moved the view: resizing fits it again.

    QPolygonF changedOutline; ///< In uv: what the last change of texels touched; empty after other changes.
    PaintOverlay overlay;
    PaintPointer pointer;
    QTimer refining; ///< Runs while the map's picture is coarse, see MapPyramid::isCoarse().
};

PaintView::PaintView(EditorState& state, const Theme& theme, StartBackdrop start, QWidget* parent)
    : PaintedArea(state, parent), m_state(std::make_unique<State>(state, theme, std::move(start), this))
{
    setObjectName(QStringLiteral("paintArea"));
    setAttribute(Qt::WA_OpaquePaintEvent);
    setMinimumSize(160, 160);
    m_state->legend = new MapLegend(this);
    m_state->refining.setSingleShot(true);
    connect(&m_state->refining, &QTimer::timeout, this, &PaintView::refine);
    connect(&state.document(), &model::Document::changed, this, &PaintView::onDocumentChanged);
    connect(&state.document(), &model::Document::undone, this, &PaintView::showChangedOutline);
    connect(&state.document(), &model::Document::redone, this, &PaintView::showChangedOutline);
    connect(&state.target(), &EditTarget::changed, this, &PaintView::refreshMap);
    connect(&state.options(), &ViewOptions::changed, this, [this] {
        lookChanged();
        refreshMap();
        refreshRings();
    });
    connect(&state.tools(), &ToolBox::activeChanged, this, [this] {
        refreshRings();
        m_state->overlay.refreshOutlines();
    });
    connect(&state.tools(), &ToolBox::settingsChanged, this, &PaintView::refreshRings);
    connect(&state.hover(), &Hover::changed, this, &PaintView::refreshRings);
    connect(&state.tools(), &ToolBox::overlayChanged, this, [this] { m_state->overlay.refreshOutlines(); });
    connect(&m_state->pointer, &PaintPointer::panWanted, this, &PaintView::panBy);
    connect(&m_state->pointer, &PaintPointer::rotateWanted, this, &PaintView::rotateBy);
    connect(&m_state->pointer, &PaintPointer::statusText, this, &PaintView::statusText);
    refreshHead();
    refreshMap();
    m_state->pointer.updateCursor();
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

void PaintView::zoomAt(QPointF position, double factor)
{
    const std::shared_ptr<const sim::TiledRaster>& raster = m_state->canvas.pyramid().raster();
    m_state->transform.zoomAt(position, factor, raster ? raster->size() : 1024);
    m_state->fitted = false;
    lookChanged();
}

void PaintView::panBy(QPointF pixels)
{
    m_state->transform.panBy(pixels);
    m_state->fitted = false;
    lookChanged();
}

void PaintView::rotateBy(double degrees)
{
    m_state->transform.rotateBy(degrees);
    lookChanged();
}

void PaintView::fit()
{
    QRectF paper(0.0, 0.0, 1.0, 1.0);
    const std::optional<QRectF> selected = m_state->editor.tools().selection().rectangle();
    if (selected && !selected->isEmpty())
        paper = QRectF(selected->x(), 1.0 - selected->bottom(), selected->width(), selected->height());
    m_state->transform.fit(paper);
    m_state->fitted = !selected.has_value();
    lookChanged();
}

void PaintView::resetView()
{
    m_state->transform.reset();
    m_state->fitted = true;
    lookChanged();
}

void PaintView::mirrorView()
{
    m_state->transform.mirror();
    lookChanged();
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
    m_state->overlay.flash(m_state->changedOutline);
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
    const auto make = [head] { return headBackdrop(head); };
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
    const model::MapSpec& spec = model::mapSpec(editor.target().map());
    const bool exists = editor.document().project().group(editor.target().group()) != nullptr;
    const QList<QRectF> changed = m_state->canvas.setMap(
        exists ? editor.document().resolved(editor.target().group(), editor.target().map()) : nullptr, spec,
        editor.options().nightPaper());
    updatePaper(changed);
    refreshLegend();
}

void PaintView::updatePaper(const QList<QRectF>& parts)
{
    const QTransform toWidget = m_state->transform.paperToWidget();
    QRegion dirty;
    const int reach = m_state->canvas.reachPx();
    for (const QRectF& part : parts)
        dirty += toWidget.mapRect(part).toAlignedRect().adjusted(-reach, -reach, reach, reach);
    update(dirty);
}

void PaintView::refine()
{
    updatePaper(m_state->canvas.refine(kRefineMs));
    if (m_state->canvas.pyramid().isCoarse())
        m_state->refining.start(0);
}

void PaintView::refreshLegend()
{
    const EditorState& editor = m_state->editor;
    const model::MapSpec& spec = model::mapSpec(editor.target().map());
    const model::HairGroup* group = editor.document().project().group(editor.target().group());
    if (group == nullptr || spec.texel == model::TexelKind::Colour)
        m_state->legend->hide();
    else
        m_state->legend->showMap(spec, group->settings, editor.options().nightPaper());
}

void PaintView::refreshRings()
{
    m_state->overlay.refreshRings();
    m_state->pointer.updateCursor();
}

void PaintView::lookChanged()
{
    m_state->canvas.invalidate();
    refreshRings();
    m_state->overlay.refreshOutlines();
    update();
}

void PaintView::paintEvent(QPaintEvent* event)
{
    QPainter painter(this);
    const PaintCanvas::Look look{.transform = m_state->transform,
                                 .devicePixelRatio = devicePixelRatioF(),
                                 .nightPaper = m_state->editor.options().nightPaper(),
                                 .wireframe = m_state->editor.options().wireframe(),
                                 .theme = m_state->theme,
                                 .font = font()};
    for (const QRect& dirty : event->region()) {
        painter.setClipRect(dirty);
        m_state->canvas.paint(painter, dirty, look);
    }
    painter.setClipRegion(event->region());
    m_state->overlay.paint(painter);
    // Refining waits until the picture has not changed for a while; refining that already runs goes on.
    if (m_state->canvas.pyramid().isCoarse() && (!m_state->refining.isActive() || m_state->refining.interval() > 0))
        m_state->refining.start(kRestMs);
}

void PaintView::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    m_state->transform.widget = QSizeF(size());
    if (m_state->fitted)
        m_state->transform.fit(QRectF(0.0, 0.0, 1.0, 1.0));
    lookChanged();
}

void PaintView::pointerPressed(const PointerSample& sample)
{
    m_state->pointer.press(sample);
}

void PaintView::pointerMoved(const PointerSample& sample)
{
    m_state->pointer.move(sample);
}

void PaintView::pointerReleased(const PointerSample& sample)
{
    m_state->pointer.release(sample);
}

void PaintView::leaveEvent(QEvent* event)
{
    QWidget::leaveEvent(event);
    m_state->pointer.leave();
}

void PaintView::wheelEvent(QWheelEvent* event)
{
    double notches = event->angleDelta().y() / kWheelNotch;
    if (event->modifiers().testFlag(Qt::AltModifier))
        notches = event->angleDelta().x() / kWheelNotch; // Some platforms turn the wheel's axis with Alt.
    if (notches != 0.0)
        zoomAt(event->position(), std::pow(kZoomPerNotch, notches));
    event->accept();
}

bool PaintView::event(QEvent* event)
{
    if (event->type() == QEvent::NativeGesture) {
        const auto* gesture = static_cast<QNativeGestureEvent*>(event);
        if (gesture->gestureType() == Qt::ZoomNativeGesture) {
            zoomAt(gesture->position(), 1.0 + gesture->value());
            return true;
        }
        if (gesture->gestureType() == Qt::RotateNativeGesture) {
            rotateBy(gesture->value());
            return true;
        }
    }
    return PaintedArea::event(event);
}

void PaintView::keyPressEvent(QKeyEvent* event)
{
    if (!m_state->pointer.handleKey(static_cast<Qt::Key>(event->key()), event->modifiers()))
        QWidget::keyPressEvent(event);
}

void PaintView::contextMenuEvent(QContextMenuEvent* event)
{
    // Ctrl+right-drag sizes the brush.
    const bool sizing = event->reason() == QContextMenuEvent::Mouse &&
                        (m_state->pointer.dragging() || event->modifiers().testFlag(Qt::ControlModifier));
    if (!sizing)
        Q_EMIT contextMenuWanted(event->globalPos());
    event->accept();
}

} // namespace hairpaint::view
