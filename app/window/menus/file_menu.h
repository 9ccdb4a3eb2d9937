// The File menu: projects, and what comes from other programs and goes to them.
#pragma once

#include "app/exchange/exchange.h"
#include "app/project/project_files.h"
#include "app/window/action_set.h"

#include <QMenu>

namespace hairpaint::app {

/// Whatever it is made with outlives its actions; Quit closes the parent's window. GUI thread.
class FileMenu : public QMenu
{
    Q_OBJECT
public:
    FileMenu(const QString& title, ActionSet& actions, ProjectFiles& files, Exchange& exchange,
             view::EditorState& editor, QWidget* parent);
    void showRecentFiles(const QStringList& paths);

private:
    void addProjectActions(ActionSet& actions, view::EditorState& editor);
    void addMapActions(ActionSet& actions, MapExchange& maps);
    void addExchangeActions(ActionSet& actions, Exchange& exchange, const view::EditorState& editor);
    static void addHeads(QMenu& menu, ActionSet& actions, HeadExchange& heads, const view::EditorState& editor);

    ProjectFiles& m_files;
    QMenu* m_recent = nullptr;
};

} // namespace hairpaint::app
