// Mouse and pen in the paint area: strokes, panning, turning, the brush's size.
#pragma once

#include "view/editing/brush_drag.h"
#include "view/editing/editor_state.h"
#include "view/editing/held_keys.h"
#include "view/editing/pointer.h"
#include "view/paint_area/uv_transform.h"

#include <QObject>

namespace hairpaint::view {

class PaintOverlay;

/// One drag at a time; also tells where the pointer hovers, and gives the area its cursor. GUI thread.
class PaintPointer : public QObject
{
    Q_OBJECT
public:
    /// All outlive it. `transform`: the area's, as it is when an event comes.
    PaintPointer(EditorState& editor, const UvTransform& transform, const PaintOverlay& overlay, QWidget& area);

    void press(const PointerSample& sample);
    void move(const PointerSample& sample);
    void release(const PointerSample& sample);
    void leave();
    /// Whether the active tool takes that key; its stroke may end by it.
    [[nodiscard]] bool handleKey(Qt::Key key, Qt::KeyboardModifiers modifiers);
    [[nodiscard]] bool dragging() const { return m_drag != Drag::None; }
    void updateCursor();

Q_SIGNALS:
    void panWanted(QPointF pixels);
    void rotateWanted(double degrees);
    /// What a drag changes: the brush's size, hardness, opacity.
    void statusText(const QString& text);

private:
    enum class Drag
    {
        None,
        Stroke,
        Pan,
        Rotate,
        Brush
    };

    [[nodiscard]] std::optional<sim::SurfacePoint> skinAt(glm::vec2 uv) const;
    [[nodiscard]] float pixelAt(const sim::SurfacePoint& point) const; ///< How large a pixel is on the skin there.
    [[nodiscard]] model::ToolEvent toolEvent(const PointerSample& sample) const;
    void hoverAt(const PointerSample& sample);

    EditorState& m_editor;
    const UvTransform& m_transform;
    const PaintOverlay& m_overlay;
    QWidget& m_area;
    HeldKeys m_keys;
    BrushDrag m_brushDrag;
    Drag m_drag = Drag::None;
    PointerSample m_pressed;
    QPointF m_last;
};

} // namespace hairpaint::view
