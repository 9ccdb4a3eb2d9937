// A folder for each open window's journal, locked while the window lives.
#pragma once

#include "model/disk/own_folder.h"
#include "model/disk/own_lock.h"

#include <QString>

#include <memory>
#include <vector>

namespace hairpaint::app {

/// The lock names the process and frees itself when that dies, whatever the clock says; nobody else's folder is ever
/// touched, no link is followed, and nothing is removed but what a window puts there. One thread at a time; what is
/// asked of the disk may wait for it.
class JournalFolder
{
public:
    /// The folder that holds the journals of this user.
    [[nodiscard]] static QString root();
    /// Creates a new one; null if nothing can be written there.
    [[nodiscard]] static std::unique_ptr<JournalFolder> create(const QString& root);
    /// The folders whose windows ended without removing them; from now on they are this process's. The one that was
    /// written last comes first.
    [[nodiscard]] static std::vector<std::unique_ptr<JournalFolder>> abandoned(const QString& root);

    /// Path of the journal's file.
    [[nodiscard]] QString file() const { return m_own->pathOf(fileName()); }
    [[nodiscard]] static QString fileName();
    [[nodiscard]] const std::shared_ptr<const model::OwnFolder>& own() const { return m_own; }
    /// Whether this process holds the lock; else nothing can be written there, so the journal may be read but not
    /// removed.
    [[nodiscard]] bool isLocked() const { return m_isLocked; }
    /// Removes it with our files in it; false if it still exists.
    bool remove();

private:
    JournalFolder(std::shared_ptr<const model::OwnFolder> root, QString name, model::OwnFolder own);

    std::shared_ptr<const model::OwnFolder> m_root;
    QString m_name;
    std::shared_ptr<const model::OwnFolder> m_own;
    model::OwnLock m_lock;
    bool m_isLocked = false;
};

} // namespace hairpaint::app
