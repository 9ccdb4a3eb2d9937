// The View menu: which areas and panels are shown, where they look from, the theme.
#pragma once

#include "app/exchange/exchange.h"
#include "app/window/action_set.h"
#include "app/window/live_preferences.h"
#include "app/window/workspace.h"

#include <QMenu>

namespace hairpaint::app {

/// Whatever it is made with outlives its actions. GUI thread.
class ViewMenu : public QMenu
{
    Q_OBJECT
public:
    ViewMenu(const QString& title, ActionSet& actions, Workspace& workspace, view::EditorState& editor,
             LivePreferences& preferences, Exchange& exchange, QWidget* parent);

private:
    void addAreas(ActionSet& actions, Workspace& workspace);
    void addLook(ActionSet& actions, Workspace& workspace, view::EditorState& editor, Exchange& exchange);
    void addThemes(ActionSet& actions, LivePreferences& preferences);
};

} // namespace hairpaint::app
