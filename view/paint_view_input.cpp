// The paint area's pointer, wheel and keys.
#include "view/paint/paint_view_state.h"
#include "view/paint_view.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QWheelEvent>

#include <cmath>
#include <numbers>
#include <utility>

namespace hairpaint::view {

namespace {

constexpr double kZoomPerNotch = 1.2;
constexpr double kWheelNotch = 120.0;

model::ToolEvent toolEvent(const PointerSample& sample, glm::vec2 uv, const model::Project& project)
{
    model::ToolEvent event{.area = model::Area::Paint,
                           .uv = uv,
                           .point = std::nullopt,
                           .pressure = sample.pressure,
                           .seconds = sample.seconds,
                           .modifiers = sample.modifiers};
    if (project.head && project.head->skin)
        event.point = project.head->skin->atUv(uv);
    return event;
}

} // namespace

void PaintView::pointerPressed(const PointerSample& sample)
{
    State& state = *m_state;
    if (state.drag != State::Drag::None)
        return;
    state.pressed = sample;
    state.last = sample.position;
    const bool left = sample.button == Qt::LeftButton;
    if (sample.button == Qt::MiddleButton || (left && state.keys.holds(Qt::Key_Space))) {
        state.drag = sample.modifiers.testFlag(Qt::ShiftModifier) ? State::Drag::Rotate : State::Drag::Pan;
    } else if (state.brushDrag.press(sample, state.keys)) {
        state.drag = State::Drag::Brush;
    } else if (left) {
        hoverAt(sample);
        state.drag = State::Drag::Stroke;
        state.editor.press(toolEvent(sample, uvAt(sample.position), state.editor.document().project()));
    }
    updateCursor();
}

void PaintView::pointerMoved(const PointerSample& sample)
{
    State& state = *m_state;
    switch (state.drag) {
    case State::Drag::None:
        hoverAt(sample);
        break;
    case State::Drag::Stroke:
        hoverAt(sample);
        state.editor.move(toolEvent(sample, uvAt(sample.position), state.editor.document().project()));
        break;
    case State::Drag::Pan:
        panBy(sample.position - state.last);
        break;
    case State::Drag::Rotate: {
        const QPointF middle = QRectF(rect()).center();
        const QPointF from = state.last - middle;
        const QPointF to = sample.position - middle;
        const double turned = std::atan2(from.x() * to.y() - from.y() * to.x(), QPointF::dotProduct(from, to));
        rotateBy(turned * 180.0 / std::numbers::pi);
        break;
    }
    case State::Drag::Brush:
        state.brushDrag.move(sample);
        Q_EMIT statusText(brushText(state.editor.toolSettings()));
        break;
    }
    state.last = sample.position;
}

void PaintView::pointerReleased(const PointerSample& sample)
{
    State& state = *m_state;
    if (state.drag == State::Drag::None || sample.button != state.pressed.button)
        return;
    const State::Drag drag = std::exchange(state.drag, State::Drag::None);
    if (drag == State::Drag::Stroke)
        state.editor.release(toolEvent(sample, uvAt(sample.position), state.editor.document().project()));
    hoverAt(sample);
    updateCursor();
}

void PaintView::hoverAt(const PointerSample& sample)
{
    const glm::vec2 uv = uvAt(sample.position);
    Hover hover{.area = model::Area::Paint, .uv = uv, .point = std::nullopt};
    const std::shared_ptr<const model::Head>& head = m_state->editor.document().project().head;
    if (head && head->skin)
        hover.point = head->skin->atUv(uv);
    m_state->editor.setHover(hover);
}

void PaintView::updateCursor()
{
    const State& state = *m_state;
    Qt::CursorShape shape = Qt::CrossCursor;
    if (state.drag == State::Drag::Pan)
        shape = Qt::ClosedHandCursor;
    else if (state.drag == State::Drag::Rotate)
        shape = Qt::SizeAllCursor;
    else if (state.keys.holds(Qt::Key_Space))
        shape = Qt::OpenHandCursor;
    else if (!state.rings.empty() && state.editor.hover() && state.editor.hover()->area == model::Area::Paint)
        shape = Qt::BlankCursor; // The ring is the cursor.
    if (cursor().shape() != shape)
        setCursor(shape);
}

void PaintView::leaveEvent(QEvent* event)
{
    QWidget::leaveEvent(event);
    const std::optional<Hover>& hover = m_state->editor.hover();
    if (m_state->drag == State::Drag::None && hover && hover->area == model::Area::Paint)
        m_state->editor.setHover(std::nullopt);
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
    return QWidget::event(event);
}

void PaintView::keyPressEvent(QKeyEvent* event)
{
    EditorState& editor = m_state->editor;
    if (editor.toolKey(static_cast<Qt::Key>(event->key()), event->modifiers())) {
        if (m_state->drag == State::Drag::Stroke && !editor.stroking())
            m_state->drag = State::Drag::None;
    } else {
        QWidget::keyPressEvent(event);
    }
}

void PaintView::contextMenuEvent(QContextMenuEvent* event)
{
    // Ctrl+right-drag sizes the brush.
    const bool sizing = event->reason() == QContextMenuEvent::Mouse &&
                        (m_state->drag != State::Drag::None || event->modifiers().testFlag(Qt::ControlModifier));
    if (!sizing)
        Q_EMIT contextMenuWanted(event->globalPos());
    event->accept();
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
    const std::optional<QRectF> selected = m_state->editor.selection().rectangle();
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

} // namespace hairpaint::view
