// The Help menu: see the header.
#include "app/window/menus/help_menu.h"

namespace hairpaint::app {

HelpMenu::HelpMenu(const QString& title, ActionSet& actions, WindowDialogs& dialogs, const view::HeadView& head,
                   QWidget* parent)
    : QMenu(title, parent)
{
    using Topic = view::HelpDialog::Topic;
    actions.add(*this,
                {{"help.help", tr("&Help…"), {Qt::SHIFT | Qt::Key_F1}, [&dialogs] { dialogs.showHelp(Topic::Tools); }},
                 {"help.keys", tr("&Keys…"), {}, [&dialogs] { dialogs.showHelp(Topic::Keys); }},
                 {"help.about", tr("&About Hair Paint"), {}, [&dialogs, &head] {
                      dialogs.showAbout(head.rendererDescription());
                  }}});
}

} // namespace hairpaint::app
