// The Map menu: the active map, its layers and its size.
#pragma once

#include "app/background/jobs.h"
#include "app/session/session.h"
#include "app/window/action_set.h"
#include "view/panels/layers_panel.h"

#include <QMenu>

namespace hairpaint::app {

/// Whatever it is made with outlives its actions; message boxes are shown over the parent's window. GUI thread.
class MapMenu : public QMenu
{
    Q_OBJECT
public:
    MapMenu(const QString& title, ActionSet& actions, Session& session, view::LayersPanel& layers, Jobs& jobs,
            QWidget* parent);

private:
    void addMaps(ActionSet& actions);
    void addLayers(ActionSet& actions, view::LayersPanel& layers);
    void addSizes(QMenu& menu);
    void tickSize(const QMenu& menu) const;
    void resizeMap(int size);

    Session& m_session;
    Jobs& m_jobs;
};

} // namespace hairpaint::app
