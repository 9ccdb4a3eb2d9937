// The Hair menu: wind, light, simulation, groups, styles.
#pragma once

#include "app/action_set.h"
#include "app/exchange.h"
#include "app/window_dialogs.h"
#include "view/head_view.h"
#include "view/panels/sidebar.h"

#include <QMenu>

namespace hairpaint::app {

/// Whatever it is made with outlives its actions. GUI thread.
class HairMenu : public QMenu
{
    Q_OBJECT
public:
    HairMenu(const QString& title, ActionSet& actions, Session& session, view::HeadView& head, view::Sidebar& sidebar,
             WindowDialogs& dialogs, Exchange& exchange, QWidget* parent);

private:
    void addWeather(ActionSet& actions, Session& session, view::HeadView& head, WindowDialogs& dialogs);
    void addSimulation(ActionSet& actions, Session& session);
};

} // namespace hairpaint::app
