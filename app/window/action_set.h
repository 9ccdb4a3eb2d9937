// Every action of the window: menu entry, key, icon and what it does, in one table, so that keys can be rebound.
#pragma once

#include "app/settings/settings.h"

#include <QAction>
#include <QByteArray>
#include <QKeySequence>
#include <QMenu>
#include <QObject>

#include <functional>
#include <vector>

namespace hairpaint::app {

/// A row of the table; everything but id, text and run may be left out.
struct ActionRow
{
    QByteArray id; ///< In the settings and for look-ups: "edit.undo".
    QString text;  ///< Translated, with its mnemonic.
    QList<QKeySequence> keys = {};
    std::function<void()> run = {};
    const char* icon = nullptr;
    std::function<bool()> on = {};       ///< Makes it a switch that shows what this says.
    std::function<bool()> enabled = {};  ///< Always, where there is none.
    std::function<QString()> label = {}; ///< Instead of `text` in the menu, where words in it change.
};

/// A name in a menu's text, which would take its & for a mark of its own.
[[nodiscard]] QString inMenu(QString name);

/// Menus, the list of keys and the help read the same table. GUI thread.
class ActionSet : public QObject
{
    Q_OBJECT
public:
    ActionSet(Settings& settings, QWidget& window);

    /// Adds the rows to the menu and the window, in order, with rebound keys where the user has set some.
    void add(QMenu& menu, const std::vector<ActionRow>& rows);
    /// Brings ticks, labels and what is enabled up to date; also done after every action.
    void follow();
    [[nodiscard]] QAction* find(QLatin1StringView id) const; ///< Null where there is none.
    [[nodiscard]] std::vector<view::KeyBinding> bindings() const;
    void remember(QAction* action, const QKeySequence& key);
    void forget(QAction* action); ///< Resets the action to its default keys.

private:
    struct AddedAction
    {
        QAction* action;
        QString section;
        QString name;
        ActionRow row;
    };
    void addRow(QMenu& menu, const ActionRow& row);

    Settings& m_settings;
    QWidget& m_window;
    std::vector<AddedAction> m_entries;
};

} // namespace hairpaint::app
