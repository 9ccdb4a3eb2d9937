// The list of actions: see the header.
#include "app/action_set.h"

#include "view/widgets/icons.h"

#include <algorithm>

namespace hairpaint::app {

ActionSet::ActionSet(Settings& settings, QWidget& window) : QObject(&window), m_settings(settings), m_window(window) {}

QAction* ActionSet::add(QMenu& menu, const ActionSpec& spec)
{
    auto* action = new QAction(spec.text, &m_window);
    action->setObjectName(QLatin1StringView(spec.id));
    action->setCheckable(spec.checkable);
    if (spec.icon != nullptr)
        action->setIcon(spec.checkable ? view::switchIcon(QLatin1StringView(spec.icon))
                                       : view::icon(QLatin1StringView(spec.icon)));
    // A menu shows the icon or the tick, and what is on must be seen.
    action->setIconVisibleInMenu(!spec.checkable);
    action->setShortcut(m_settings.key(action->objectName()).value_or(spec.key));
    if (spec.run)
        connect(action, &QAction::triggered, &m_window, spec.run);
    menu.addAction(action);
    m_window.addAction(action); // Keys work while the menu bar is hidden too.
    m_entries.push_back({.action = action, .section = menu.title().remove(QLatin1Char('&')), .defaultKey = spec.key});
    return action;
}

QAction* ActionSet::find(QLatin1StringView id) const
{
    const auto found =
        std::ranges::find_if(m_entries, [id](const Entry& entry) { return entry.action->objectName() == id; });
    return found == m_entries.end() ? nullptr : found->action;
}

std::vector<view::KeyBinding> ActionSet::bindings() const
{
    std::vector<view::KeyBinding> bindings;
    for (const Entry& entry : m_entries)
        bindings.push_back({.action = entry.action, .section = entry.section, .defaultKey = entry.defaultKey});
    return bindings;
}

void ActionSet::remember(QAction* action, const QKeySequence& key)
{
    m_settings.setKey(action->objectName(), key);
}

} // namespace hairpaint::app
