// Mouse and pen in either area.
#include "view/editing/painted_area.h"

#include "view/editing/editor_state.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPointingDevice>
#include <QTabletEvent>

#include <utility>

namespace hairpaint::view {

PaintedArea::PaintedArea(EditorState& editor, QWidget* parent) : QWidget(parent), m_editor(editor)
{
    setMouseTracking(true);
    setTabletTracking(true);
    setFocusPolicy(Qt::StrongFocus);
}

void PaintedArea::mousePressEvent(QMouseEvent* event)
{
    pointerPressed(PointerSample::of(*event));
}

void PaintedArea::mouseMoveEvent(QMouseEvent* event)
{
    pointerMoved(PointerSample::of(*event));
}

void PaintedArea::mouseReleaseEvent(QMouseEvent* event)
{
    pointerReleased(PointerSample::of(*event));
}

bool PaintedArea::event(QEvent* event)
{
    // What a tool waits to go on with is edited with this key, not the layer.
    if (event->type() == QEvent::ShortcutOverride && m_editor.tools().active().pending() &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Delete) {
        event->accept();
        return true;
    }
    return QWidget::event(event);
}

void PaintedArea::tabletEvent(QTabletEvent* event)
{
    const PointerSample sample = PointerSample::of(*event);
    // Accepted, so that no mouse event without pressure follows.
    event->accept();
    if (event->type() == QEvent::TabletPress) {
        const bool turned = event->pointerType() == QPointingDevice::PointerType::Eraser;
        m_eraserTurned = turned && m_editor.tools().choose(m_editor.tools().with(&model::ToolTraits::erases));
        pointerPressed(sample);
    } else if (event->type() == QEvent::TabletMove) {
        pointerMoved(sample);
    } else if (event->type() == QEvent::TabletRelease) {
        pointerReleased(sample);
        if (std::exchange(m_eraserTurned, false))
            m_editor.tools().toggle(m_editor.tools().with(&model::ToolTraits::erases));
    }
}

} // namespace hairpaint::view
