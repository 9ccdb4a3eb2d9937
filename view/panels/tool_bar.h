// The column of tools at the left edge.
#pragma once

#include "view/editor_state.h"

#include <QWidget>

class QAction;
class QToolButton;
class QVBoxLayout;

namespace hairpaint::view {

/// 44 px wide. One checkable button a tool, below them the value pair; at the foot the actions of addFootAction.
class ToolBar : public QWidget
{
    Q_OBJECT
public:
    explicit ToolBar(EditorState& state, QWidget* parent = nullptr);
    /// The action that chooses a tool too: the tooltip tells its key, whenever that is rebound. Not owned.
    void setAction(model::ToolId tool, const QAction& action);
    /// A button for one of the main window's actions (mirror, wireframe, ...) at the foot. Not owned.
    void addFootAction(QAction* action);

private:
    void follow();

    EditorState& m_state;
    std::vector<QToolButton*> m_buttons; ///< In the order of state.tools().
    QVBoxLayout* m_foot = nullptr;
};

} // namespace hairpaint::view
