// The table of actions: see the header.
#include "app/window/action_set.h"

#include "view/look/icons.h"

#include <algorithm>

namespace hairpaint::app {

namespace {

/// Without the mark of its mnemonic and a key that stands behind a tab.
QString wordsOf(const QString& text)
{
    QString words = text.section(QLatin1Char('\t'), 0, 0);
    words.replace(QStringLiteral("&&"), QStringLiteral("\x01"));
    words.remove(QLatin1Char('&'));
    return words.replace(QLatin1Char('\x01'), QLatin1Char('&'));
}

} // namespace

QString inMenu(QString name)
{
    return name.replace(QLatin1Char('&'), QStringLiteral("&&"));
}

ActionSet::ActionSet(Settings& settings, QWidget& window) : QObject(&window), m_settings(settings), m_window(window) {}

void ActionSet::add(QMenu& menu, const std::vector<ActionRow>& rows)
{
    for (const ActionRow& row : rows)
        addRow(menu, row);
}

void ActionSet::addRow(QMenu& menu, const ActionRow& row)
{
    const bool checkable = static_cast<bool>(row.on);
    auto* action = new QAction(row.text, &m_window);
    action->setObjectName(QString::fromLatin1(row.id));
    action->setCheckable(checkable);
    if (row.icon != nullptr)
        action->setIcon(checkable ? view::switchIcon(QLatin1StringView(row.icon))
                                  : view::icon(QLatin1StringView(row.icon)));
    // A menu shows the icon or the tick, and what is on must be seen.
    action->setIconVisibleInMenu(!checkable);
    if (const std::optional<QKeySequence> key = m_settings.key(action->objectName()))
        action->setShortcut(*key);
    else
        action->setShortcuts(row.keys);
    connect(action, &QAction::triggered, &m_window, [this, run = row.run] {
        run();
        follow();
    });
    menu.addAction(action);
    m_window.addAction(action); // Keys work while the menu bar is hidden too.
    m_entries.push_back({.action = action,
                         .section = wordsOf(menu.title()),
                         .name = wordsOf(row.text).remove(QChar(0x2026)),
                         .row = row});
}

void ActionSet::follow()
{
    for (const AddedAction& entry : m_entries) {
        if (entry.row.on)
            entry.action->setChecked(entry.row.on());
        if (entry.row.enabled)
            entry.action->setEnabled(entry.row.enabled());
        if (entry.row.label)
            entry.action->setText(entry.row.label());
    }
}

QAction* ActionSet::find(QLatin1StringView id) const
{
    const auto found =
        std::ranges::find_if(m_entries, [id](const AddedAction& entry) { return entry.action->objectName() == id; });
    return found == m_entries.end() ? nullptr : found->action;
}

std::vector<view::KeyBinding> ActionSet::bindings() const
{
    std::vector<view::KeyBinding> bindings;
    for (const AddedAction& entry : m_entries)
        bindings.push_back(
            {.action = entry.action, .section = entry.section, .name = entry.name, .defaultKeys = entry.row.keys});
    return bindings;
}

void ActionSet::remember(QAction* action, const QKeySequence& key)
{
    m_settings.setKey(action->objectName(), key);
}

void ActionSet::forget(QAction* action)
{
    m_settings.removeKey(action->objectName());
}

} // namespace hairpaint::app
