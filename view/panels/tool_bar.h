// The column of tools at the left edge.
#pragma once

#include "view/editing/editor_state.h"

#include <QWidget>

class QAction;
class QGridLayout;
class QToolButton;

namespace hairpaint::view {

/// 44 px wide, of two columns where the window is too low for one. One checkable button a tool, below them the value
/// pair; at the foot the actions of addFootAction.
class ToolBar : public QWidget
{
    Q_OBJECT
public:
    explicit ToolBar(EditorState& state, QWidget* parent = nullptr);
    /// The action that chooses a tool too: the tooltip tells its key, whenever that is rebound. Not owned.
    void setAction(model::ToolId tool, const QAction& action);
    /// A button for one of the main window's actions (mirror, wireframe, ...) at the foot. Not owned.
    void addFootAction(QAction* action);
    [[nodiscard]] QSize minimumSizeHint() const override; ///< The size of the bar in two columns.

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void follow();
    [[nodiscard]] int heightOf(int columns) const;
    void arrange(int columns);

    EditorState& m_state;
    std::vector<QToolButton*> m_buttons; ///< In the order of state.tools().all().
    std::vector<QToolButton*> m_footButtons;
    QGridLayout* m_tools = nullptr;
    QGridLayout* m_foot = nullptr;
    int m_columns = 0;
};

} // namespace hairpaint::view
