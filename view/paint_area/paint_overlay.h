// The brush's rings and the outlines that the paint area draws over the map.
#pragma once

#include "model/tools/tool.h"
#include "view/paint_area/uv_transform.h"

#include <QBasicTimer>
#include <QObject>
#include <QPolygonF>
#include <QRect>

#include <vector>

class QPainter;
class QWidget;

namespace hairpaint::view {

class EditorState;

/// Rings of the pointer and its mirrored twin; outlines of the active tool and of the selection, whose dashes march;
/// for a moment the outline of what undo or redo changed. It repaints of `area` what differs. GUI thread; all that it
/// is made of must outlive it.
class PaintOverlay : public QObject
{
public:
    PaintOverlay(EditorState& editor, const UvTransform& transform, QWidget& area);

    void refreshRings();
    void refreshOutlines();
    void flash(QPolygonF uvOutline); ///< In uv; empty shows none.
    [[nodiscard]] bool hasRing() const { return !m_rings.empty(); }
    void paint(QPainter& painter) const;

protected:
    void timerEvent(QTimerEvent* event) override;

private:
    void march();
    void paintOutlines(QPainter& painter) const;
    void paintRings(QPainter& painter) const;

    EditorState& m_editor;
    const UvTransform& m_transform;
    QWidget& m_area;
    std::vector<QPolygonF> m_rings; ///< In widget coordinates.
    QRect m_ringsBounds;
    std::vector<model::OverlayShape> m_outlines;
    QRect m_outlinesBounds;
    QPolygonF m_flashed;
    QBasicTimer m_flash;
    QBasicTimer m_marching;
    int m_marchStep = 0;
};

} // namespace hairpaint::view
