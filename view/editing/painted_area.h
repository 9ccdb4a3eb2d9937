// The handling of mouse and pen that both areas have in common.
#pragma once

#include "view/editing/pointer.h"

#include <QWidget>

namespace hairpaint::view {

/// How large a tool's handle is drawn around its position.
[[nodiscard]] inline QRectF handleAt(QPointF centre)
{
    constexpr double kHalfPx = 2.5;
    return {centre.x() - kHalfPx, centre.y() - kHalfPx, 2.0 * kHalfPx, 2.0 * kHalfPx};
}

class EditorState;

/// Merges mouse and pen into one stream of samples. The pen's other end chooses the eraser for its stroke.
class PaintedArea : public QWidget
{
    Q_OBJECT
public:
    PaintedArea(EditorState& editor, QWidget* parent);

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void tabletEvent(QTabletEvent* event) override;
    bool event(QEvent* event) override;

    virtual void pointerPressed(const PointerSample& sample) = 0;
    virtual void pointerMoved(const PointerSample& sample) = 0;
    virtual void pointerReleased(const PointerSample& sample) = 0;

private:
    EditorState& m_editor;
    bool m_eraserTurned = false;
};

} // namespace hairpaint::view
