// The value that is painted and the second one behind it, as two overlapping squares.
#pragma once

#include "view/editor_state.h"

#include <QWidget>

namespace hairpaint::view {

/// A click swaps the two.
class ValuePair : public QWidget
{
    Q_OBJECT
public:
    explicit ValuePair(EditorState& state, QWidget* parent = nullptr);
    [[nodiscard]] QSize sizeHint() const override { return {36, 28}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

private:
    EditorState& m_state;
};

/// X and D, for the main window's actions too.
void swapValues(EditorState& state);
void resetValues(EditorState& state);

} // namespace hairpaint::view
