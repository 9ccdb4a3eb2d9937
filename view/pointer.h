// What mouse and pen have in common, and the drags that both areas share.
#pragma once

#include "model/tools/tool_settings.h"

#include <QInputEvent>
#include <QPointF>
#include <QString>

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

    [[nodiscard]] static PointerSample of(const QMouseEvent& event);
    [[nodiscard]] static PointerSample of(const QTabletEvent& event);
};

/// Ctrl+right-drag: sideways the size, up and down the hardness. `pixels` since the press.
[[nodiscard]] model::ToolSettings draggedBrush(const model::ToolSettings& start, QPointF pixels);
/// O and drag sideways.
[[nodiscard]] model::ToolSettings draggedOpacity(const model::ToolSettings& start, QPointF pixels);
/// "Size 3.2 cm, hardness 60 %, opacity 100 %", for the status bar.
[[nodiscard]] QString brushText(const model::ToolSettings& settings);

} // namespace hairpaint::view
