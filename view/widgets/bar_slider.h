// A number as a filled bar, set by hand.
#pragma once

#include "view/widgets/bar_value.h"

#include <QPointer>

namespace hairpaint::view {

class NumberEdit;

/// Drag sets, Ctrl makes it ten times finer, double-click or Enter types (see number_text.h), right-click resets,
/// arrows and (only while it has the focus) the wheel step. Esc while dragging or typing takes the change back.
class BarSlider : public BarValue
{
    Q_OBJECT
public:
    explicit BarSlider(const QString& label, QWidget* parent = nullptr);

    /// Before it stands for something else: a change by the user is done, and what is being typed is dropped.
    void release();

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool event(QEvent* event) override;

private:
    /// A key that is the first of a number.
    [[nodiscard]] bool startsTyping(const QKeyEvent& event) const;
    void openEditor();
    void take(double typed);
    void closeEditor(const QString& problem);

    bool m_reachedByKey = false; ///< Whatever has the focus now, the last time it came by mouse or key.
    bool m_dragging = false;
    bool m_moved = false;
    double m_dragFraction = 0.0;
    double m_lastX = 0.0;
    double m_pressX = 0.0;
    int m_wheelRest = 0;
    QPointer<NumberEdit> m_editor;
};

} // namespace hairpaint::view
