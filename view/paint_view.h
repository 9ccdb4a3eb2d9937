// The paint area: the active map over the head's shading, with the uv wireframe on top.
#pragma once

#include "view/theme.h"

#include <QWidget>

#include <glm/glm.hpp>

#include <memory>

namespace hairpaint::view {

class EditorState;

/// Painted with QPainter alone, so that it works without OpenGL. Home, F and Shift+M are the window's actions, which
/// call the slots; Space, O and Esc are read here while the pointer is used.
class PaintView : public QWidget
{
    Q_OBJECT
public:
    PaintView(EditorState& state, const Theme& theme, QWidget* parent = nullptr);
    ~PaintView() override;

    void setTheme(const Theme& theme);

    /// Between uv (v up) and this widget's own coordinates.
    [[nodiscard]] glm::vec2 uvAt(QPointF position) const;
    [[nodiscard]] QPointF positionOf(glm::vec2 uv) const;
    /// 1 shows the whole map just fitting.
    [[nodiscard]] double zoom() const;
    [[nodiscard]] bool mirrored() const;

public Q_SLOTS:
    void zoomIn();
    void zoomOut();
    void zoomAt(QPointF position, double factor);
    void panBy(QPointF pixels);
    void rotateBy(double degrees);
    void fit();       ///< The selection where there is one, else the whole map.
    void resetView(); ///< The whole map, not rotated, not mirrored.
    void mirrorView();

Q_SIGNALS:
    /// What is under the pointer: the value, or what went wrong.
    void statusText(const QString& text);
    void contextMenuWanted(const QPoint& globalPosition);
    void viewChanged();

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace hairpaint::view
