// A pointer event of a mouse or a pen.
#pragma once

#include <QInputEvent>
#include <QPointF>

class QMouseEvent;
class QTabletEvent;

namespace hairpaint::view {

/// One event of a mouse or a pen, in a widget's own coordinates.
struct PointerSample
{
    QPointF position;
    Qt::MouseButton button = Qt::NoButton; ///< That went down or up.
    Qt::MouseButtons buttons = Qt::NoButton;
    Qt::KeyboardModifiers modifiers = Qt::NoModifier;
    float pressure = 1.0F; ///< 0..1
    double seconds = 0.0;
    bool again = false; ///< The second press of a double click.

    [[nodiscard]] static PointerSample of(const QMouseEvent& event);
    [[nodiscard]] static PointerSample of(const QTabletEvent& event);
};

} // namespace hairpaint::view
