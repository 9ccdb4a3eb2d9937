// A small state machine over presses, moves and releases.
#include "view/paint_area/paint_pointer.h"

#include "view/paint_area/paint_overlay.h"

#include <QWidget>

#include <cmath>
#include <numbers>
#include <utility>

namespace hairpaint::view {

PaintPointer::PaintPointer(EditorState& editor, const UvTransform& transform, const PaintOverlay& overlay,
                           QWidget& area)
    : m_editor(editor), m_transform(transform), m_overlay(overlay), m_area(area),
      m_keys({Qt::Key_Space, Qt::Key_O}, &area), m_brushDrag{editor}
{
    connect(&m_keys, &HeldKeys::changed, this, &PaintPointer::updateCursor);
}

std::optional<sim::SurfacePoint> PaintPointer::skinAt(glm::vec2 uv) const
{
    const std::shared_ptr<const model::Head>& head = m_editor.document().project().head;
    return head && head->skin ? head->skin->atUv(uv) : std::nullopt;
}

float PaintPointer::pixelAt(const sim::SurfacePoint& point) const
{
    return 0.5F * (glm::length(point.dPduHd) + glm::length(point.dPdvHd)) / static_cast<float>(m_transform.pxPerPaper);
}

model::ToolEvent PaintPointer::toolEvent(const PointerSample& sample) const
{
    const glm::vec2 uv = m_transform.toUv(sample.position);
    model::ToolEvent event{.area = model::Area::Paint,
                           .uv = uv,
                           .point = skinAt(uv),
                           .pressure = sample.pressure,
                           .seconds = sample.seconds,
                           .modifiers = sample.modifiers,
                           .again = sample.again};
    if (event.point)
        event.pixelM = pixelAt(*event.point);
    return event;
}

void PaintPointer::press(const PointerSample& sample)
{
    if (dragging())
        return;
    m_pressed = sample;
    m_last = sample.position;
    const bool left = sample.button == Qt::LeftButton;
    if (sample.button == Qt::MiddleButton || (left && m_keys.holds(Qt::Key_Space))) {
        m_drag = sample.modifiers.testFlag(Qt::ShiftModifier) ? Drag::Rotate : Drag::Pan;
    } else if (m_brushDrag.press(sample, m_keys)) {
        m_drag = Drag::Brush;
    } else if (left) {
        hoverAt(sample);
        m_drag = Drag::Stroke;
        m_editor.tools().press(toolEvent(sample));
    }
    updateCursor();
}

void PaintPointer::move(const PointerSample& sample)
{
    switch (m_drag) {
    case Drag::None:
        hoverAt(sample);
        break;
    case Drag::Stroke:
        hoverAt(sample);
        m_editor.tools().move(toolEvent(sample));
        break;
    case Drag::Pan:
        Q_EMIT panWanted(sample.position - m_last);
        break;
    case Drag::Rotate: {
        const QPointF middle = QRectF(m_area.rect()).center();
        const QPointF from = m_last - middle;
        const QPointF to = sample.position - middle;
        const double turned = std::atan2(from.x() * to.y() - from.y() * to.x(), QPointF::dotProduct(from, to));
        Q_EMIT rotateWanted(turned * 180.0 / std::numbers::pi);
        break;
    }
    case Drag::Brush:
        m_brushDrag.move(sample);
        Q_EMIT statusText(brushText(m_editor.tools().settings()));
        break;
    }
    m_last = sample.position;
}

void PaintPointer::release(const PointerSample& sample)
{
    if (!dragging() || sample.button != m_pressed.button)
        return;
    if (std::exchange(m_drag, Drag::None) == Drag::Stroke)
        m_editor.tools().release(toolEvent(sample));
    hoverAt(sample);
    updateCursor();
}

void PaintPointer::leave()
{
    const std::optional<HoverPoint>& hover = m_editor.hover().at();
    if (!dragging() && hover && hover->area == model::Area::Paint)
        m_editor.hover().set(std::nullopt);
}

bool PaintPointer::handleKey(Qt::Key key, Qt::KeyboardModifiers modifiers)
{
    if (!m_editor.tools().key(key, modifiers))
        return false;
    if (m_drag == Drag::Stroke && !m_editor.tools().stroking())
        m_drag = Drag::None;
    return true;
}

void PaintPointer::hoverAt(const PointerSample& sample)
{
    const glm::vec2 uv = m_transform.toUv(sample.position);
    HoverPoint hover{.area = model::Area::Paint, .uv = uv, .point = skinAt(uv)};
    if (hover.point)
        hover.pixelM = pixelAt(*hover.point);
    m_editor.hover().set(hover);
}

void PaintPointer::updateCursor()
{
    const std::optional<HoverPoint>& hover = m_editor.hover().at();
    Qt::CursorShape shape = Qt::CrossCursor;
    if (m_drag == Drag::Pan)
        shape = Qt::ClosedHandCursor;
    else if (m_drag == Drag::Rotate)
        shape = Qt::SizeAllCursor;
    else if (m_keys.holds(Qt::Key_Space))
        shape = Qt::OpenHandCursor;
    else if (m_overlay.hasRing() && hover && hover->area == model::Area::Paint)
        shape = Qt::BlankCursor; // The ring is the cursor.
    if (m_area.cursor().shape() != shape)
        m_area.setCursor(shape);
}

} // namespace hairpaint::view
