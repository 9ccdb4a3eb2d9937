// The areas' context menu: see the header.
#include "app/window/menus/area_menu.h"

#include "app/window/menus/worn_order.h"

namespace hairpaint::app {

AreaMenu::AreaMenu(const ActionSet& actions, QWidget* parent) : QMenu(parent)
{
    for (const char* id : std::initializer_list<const char*>{"edit.undo", "edit.redo",      nullptr,
                                                             "edit.cut",  "edit.copy",      "edit.paste",
                                                             "edit.fill", "edit.clear",     nullptr,
                                                             "edit.all",  "edit.none",      "edit.invert",
                                                             nullptr,     "file.loadImage", "file.saveImage",
                                                             nullptr,     "view.wireframe", "view.night",
                                                             "view.fit",  "view.home",      "view.turnToBrush",
                                                             nullptr}) {
        if (id == nullptr)
            addSeparator();
        else
            addAction(actions.find(QLatin1StringView(id)));
    }
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
