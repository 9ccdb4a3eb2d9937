// The value that is painted and the second one behind it, as two overlapping squares and an arrow that swaps them.
#pragma once

#include "view/editing/editor_state.h"

#include <QWidget>

namespace hairpaint::view {

/// A click on a square asks for its picker, one on the arrow swaps the two; Return and Space ask for the picker too.
class ValuePair : public QWidget
{
    Q_OBJECT
public:
    explicit ValuePair(EditorState& state, QWidget* parent = nullptr);
    [[nodiscard]] QSize sizeHint() const override { return {36, 34}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }
    /// Where the arrow is, in this widget.
    [[nodiscard]] QRect arrowRect() const;

Q_SIGNALS:
    void pickWanted(bool second); ///< `second`: for the value behind.

protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

private:
    [[nodiscard]] QRect squareRect(bool second) const;

    EditorState& m_state;
};

/// X and D, for the main window's actions too.
void swapValues(EditorState& state);
void resetValues(EditorState& state);

} // namespace hairpaint::view
