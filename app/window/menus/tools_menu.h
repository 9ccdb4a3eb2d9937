// The Tools menu: the tools, the value pair, the brush's size.
#pragma once

#include "app/window/action_set.h"
#include "view/editing/editor_state.h"

#include <QMenu>

namespace hairpaint::app {

/// Whatever it is made with outlives its actions. GUI thread.
class ToolsMenu : public QMenu
{
    Q_OBJECT
public:
    ToolsMenu(const QString& title, ActionSet& actions, view::EditorState& editor, QWidget* parent);
};

} // namespace hairpaint::app
