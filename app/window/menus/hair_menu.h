// The Hair menu: wind, light, skin, simulation, groups, styles.
#pragma once

#include "app/exchange/exchange.h"
#include "app/styles/face_hair_switch.h"
#include "app/window/action_set.h"
#include "app/window/hold_hair.h"
#include "app/window/window_dialogs.h"
#include "app/window/workspace.h"
#include "view/head_area/head_view.h"
#include "view/panels/sidebar.h"

#include <QMenu>

namespace hairpaint::app {

/// Whatever it is made with outlives its actions. GUI thread.
class HairMenu : public QMenu
{
    Q_OBJECT
public:
    HairMenu(const QString& title, ActionSet& actions, Session& session, Workspace& workspace, WindowDialogs& dialogs,
             Exchange& exchange, Jobs& jobs, QWidget* parent);

private:
    void addWeather(ActionSet& actions, Session& session, view::HeadView& head, WindowDialogs& dialogs);
    void addSkin(ActionSet& actions, Session& session);
    void addSimulation(ActionSet& actions, Session& session);
    void addRows(QMenu& menu, ActionSet& actions, WindowDialogs& dialogs);
    void addWorn(ActionSet& actions, Session& session, view::HeadView& head, WindowDialogs& dialogs,
                 Exchange& exchange);
    void addCuts(ActionSet& actions, Session& session, WindowDialogs& dialogs, Exchange& exchange);
    void addMotions(ActionSet& actions, Session& session, view::HeadView& head);

    FaceHairSwitch m_faceHair;
    HoldHair m_holdHair;
};

} // namespace hairpaint::app
