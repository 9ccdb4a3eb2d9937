// What the paint area remembers between events.
#pragma once

#include "view/brush_drag.h"
#include "view/editor_state.h"
#include "view/held_keys.h"
#include "view/map_legend.h"
#include "view/paint/paint_canvas.h"
#include "view/paint_view.h"
#include "view/pointer.h"

#include <QBasicTimer>

namespace hairpaint::view {

struct PaintView::State
{
    enum class Drag
    {
        None,
        Stroke,
        Pan,
        Rotate,
        Brush
    };

    State(EditorState& editorState, const Theme& startTheme, StartBackdrop start, QObject* parent)
        : editor(editorState), theme(startTheme), keys({Qt::Key_Space, Qt::Key_O}, parent),
          startBackdrop(std::move(start))
    {}

    EditorState& editor;
    Theme theme;
    HeldKeys keys;
    StartBackdrop startBackdrop;
    std::shared_ptr<const model::Head> head; ///< Whose backdrop is shown or made.
    PaintCanvas canvas;
    MapLegend* legend = nullptr; ///< A child.
    UvTransform transform;
    bool fitted = true; ///< Nobody has moved the view: resizing fits it again.

    Drag drag = Drag::None;
    PointerSample pressed;
    QPointF last;
    BrushDrag brushDrag{editor};

    std::vector<QPolygonF> rings; ///< On the widget: the pointer's and its mirrored twin.
    QRect ringsBounds;
    std::vector<model::OverlayShape> overlay;
    QRect overlayBounds;
    QPolygonF changedOutline; ///< In uv: what the last change of texels touched; empty after other changes.
    QPolygonF shownOutline;
    QBasicTimer outlined;
    QBasicTimer march;
    int marchStep = 0;
};

} // namespace hairpaint::view
