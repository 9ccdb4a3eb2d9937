// The Help menu: help, keys, about the program.
#pragma once

#include "app/window/action_set.h"
#include "app/window/window_dialogs.h"
#include "view/head_area/head_view.h"

#include <QMenu>

namespace hairpaint::app {

/// Whatever it is made with outlives its actions. GUI thread.
class HelpMenu : public QMenu
{
    Q_OBJECT
public:
    HelpMenu(const QString& title, ActionSet& actions, WindowDialogs& dialogs, const view::HeadView& head,
             QWidget* parent);
};

} // namespace hairpaint::app
