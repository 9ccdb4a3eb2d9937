// The context menus of both areas.
#pragma once

#include "app/window/action_set.h"

#include <QMenu>

#include <initializer_list>

namespace hairpaint::app {

/// What of the other menus is wanted at hand while painting: the same actions, which it does not own. GUI thread.
class AreaMenu : public QMenu
{
    Q_OBJECT
public:
    enum class Area
    {
        Map,
        Head
    };
    /// All menus' actions are in the set already.
    AreaMenu(Area area, const ActionSet& actions, QWidget* parent);

private:
    /// A null pointer among the ids stands for a separator.
    void add(const ActionSet& actions, std::initializer_list<const char*> ids);
    void addWorn(const ActionSet& actions); ///< What can be tied and put on where the pointer was.
};

} // namespace hairpaint::app
