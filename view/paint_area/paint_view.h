// The paint area: the active map over the head's shading, with the uv wireframe on top.
#pragma once

#include "view/editing/painted_area.h"
#include "view/look/theme.h"
#include "view/paint_area/head_backdrop.h"

#include <glm/glm.hpp>

#include <memory>

namespace hairpaint::model {
struct Change;
}

namespace hairpaint::view {

/// Painted with QPainter alone, so that it works without OpenGL. Home, F and Shift+M are the window's actions, which
/// call the slots; Space, O, Esc and Enter are read here.
class PaintView : public PaintedArea
{
    Q_OBJECT
public:
    /// A head's shading and wireframe come later where `start` makes them; without it they are there at once.
    PaintView(EditorState& state, const Theme& theme, StartBackdrop start = {}, QWidget* parent = nullptr);
    ~PaintView() override;

    void setTheme(const Theme& theme);

    /// Between uv (v up) and this widget's own coordinates.
    [[nodiscard]] glm::vec2 uvAt(QPointF position) const;
    [[nodiscard]] QPointF positionOf(glm::vec2 uv) const;
    /// 1 shows the whole map just fitting.
    [[nodiscard]] double zoom() const;
    [[nodiscard]] bool mirrored() const;
    [[nodiscard]] double rotationDeg() const;

    [[nodiscard]] QSize sizeHint() const override;

public Q_SLOTS:
    void zoomAt(QPointF position, double factor);
    void panBy(QPointF pixels);
    void rotateBy(double degrees);
    void fit();       ///< The selection where there is one, else the whole map.
    void resetView(); ///< The whole map, not rotated, not mirrored.
    void mirrorView();

Q_SIGNALS:
    /// What a drag changes: the brush's size, hardness, opacity.
    void statusText(const QString& text);
    void contextMenuWanted(const QPoint& globalPosition);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    struct State;

    void pointerPressed(const PointerSample& sample) override;
    void pointerMoved(const PointerSample& sample) override;
    void pointerReleased(const PointerSample& sample) override;

    void onDocumentChanged(const model::Change& change);
    void showChangedOutline(); ///< For a moment, as undo and redo do.
    void updatePaper(const QList<QRectF>& parts);
    void refine();     ///< What is drawn of samples of the map, a few milliseconds' worth.
    void refreshMap(); ///< Takes the active map's resolved raster and repaints what differs.
    void refreshHead();
    void refreshRings();
    void refreshLegend();
    void lookChanged();

    std::unique_ptr<State> m_state;
};

} // namespace hairpaint::view
