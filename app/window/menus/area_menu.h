// The context menu of both areas.
#pragma once

#include "app/window/action_set.h"

#include <QMenu>

namespace hairpaint::app {

/// What of the other menus is wanted at hand while painting: the same actions, which it does not own. GUI thread.
class AreaMenu : public QMenu
{
    Q_OBJECT
public:
    /// All menus' actions are in the set already.
    AreaMenu(const ActionSet& actions, QWidget* parent);
};

} // namespace hairpaint::app
