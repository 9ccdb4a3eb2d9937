// Every action of the window: menu entry, key, icon and what it does, in one list, so that keys can be rebound.
#pragma once

#include "app/settings.h"

#include <QAction>
#include <QKeySequence>
#include <QMenu>
#include <QObject>

#include <functional>
#include <vector>

namespace hairpaint::app {

/// How an action is made; everything but id, text and run may be left out.
struct ActionSpec
{
    const char* id; ///< In the settings and for look-ups: "edit.undo".
    QString text;   ///< Translated, with its mnemonic.
    QKeySequence key = {};
    std::function<void()> run = {};
    const char* icon = nullptr;
    bool checkable = false;
};

class ActionSet : public QObject
{
    Q_OBJECT
public:
    ActionSet(Settings& settings, QWidget& window);

    /// Adds it to the menu and the window, with the rebound key where the user has set one.
    QAction* add(QMenu& menu, const ActionSpec& spec);
    [[nodiscard]] QAction* find(QLatin1StringView id) const; ///< Null where there is none.
    [[nodiscard]] std::vector<view::KeyBinding> bindings() const;
    void remember(QAction* action, const QKeySequence& key);

private:
    struct Entry
    {
        QAction* action;
        QString section;
        QKeySequence defaultKey;
    };
    Settings& m_settings;
    QWidget& m_window;
    std::vector<Entry> m_entries;
};

} // namespace hairpaint::app
