// The Edit menu: undo, clipboard, selection, mirror, preferences.
#pragma once

#include "app/window/action_set.h"
#include "app/window/clip_commands.h"
#include "app/window/window_dialogs.h"
#include "view/panels/layers_panel.h"

#include <QMenu>

namespace hairpaint::app {

/// Whatever it is made with outlives its actions. GUI thread.
class EditMenu : public QMenu
{
    Q_OBJECT
public:
    EditMenu(const QString& title, ActionSet& actions, Session& session, ClipCommands& clip, view::LayersPanel& layers,
             WindowDialogs& dialogs, QWidget* parent);

private:
    void addUndo(ActionSet& actions, Session& session);
    void addClipboard(ActionSet& actions, ClipCommands& clip, view::LayersPanel& layers);
    void addSelection(ActionSet& actions, view::EditorState& editor);
};

} // namespace hairpaint::app
