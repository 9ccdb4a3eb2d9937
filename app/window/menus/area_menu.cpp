// The areas' context menus: see the header.
#include "app/window/menus/area_menu.h"

#include "app/window/menus/worn_order.h"

namespace hairpaint::app {

AreaMenu::AreaMenu(Area area, const ActionSet& actions, QWidget* parent) : QMenu(parent)
{
    add(actions, {"edit.undo", "edit.redo", nullptr});
    if (area == Area::Head) {
        addWorn(actions);
        add(actions, {nullptr, "view.home", "view.turnToBrush", nullptr, "edit.fill", "edit.clear", nullptr, "edit.all",
                      "edit.none", "edit.invert"});
    } else {
        add(actions, {"edit.cut", "edit.copy", "edit.paste", "edit.fill", "edit.clear", nullptr, "edit.all",
                      "edit.none", "edit.invert", nullptr, "file.loadImage", "file.saveImage", nullptr,
                      "view.wireframe", "view.night", "view.fit", "view.home", nullptr});
        addWorn(actions);
    }
}

void AreaMenu::add(const ActionSet& actions, std::initializer_list<const char*> ids)
{
    for (const char* id : ids) {
        if (id == nullptr)
            addSeparator();
        else
            addAction(actions.find(QLatin1StringView(id)));
    }
}

void AreaMenu::addWorn(const ActionSet& actions)
{
    QMenu* worn = addMenu(tr("Tie and put on"));
    worn->setToolTipsVisible(true);
    for (const model::WornSpec* spec : wornInMenus()) {
        if (spec == nullptr) {
            worn->addSeparator();
            continue;
        }
        worn->addAction(actions.find(QLatin1StringView(QByteArray("hair.add") + spec->action)));
        if (spec->tie == sim::TieForm::Tail)
            worn->addAction(actions.find(QLatin1StringView("hair.addTwinTails")));
    }
    addAction(actions.find(QLatin1StringView("hair.mirrorWorn")));
    addAction(actions.find(QLatin1StringView("hair.removeWorn")));
}

} // namespace hairpaint::app
