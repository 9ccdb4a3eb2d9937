// Folders and their locks.
#include "app/background/journal_folder.h"

#include <QDir>
#include <QStandardPaths>
#include <QUuid>

#include <algorithm>
#include <utility>

namespace hairpaint::app {

namespace {

const QString kLock = QStringLiteral("lock");
const QString kJournal = QStringLiteral("journal");
constexpr int kFolderTries = 4;

std::shared_ptr<const model::OwnFolder> openRoot(const QString& root)
{
    std::optional<model::OwnFolder> folder = model::OwnFolder::open(root);
    return folder ? std::make_shared<const model::OwnFolder>(std::move(*folder)) : nullptr;
}

} // namespace

QString JournalFolder::root()
{
    return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + QStringLiteral("/journals");
}

QString JournalFolder::fileName()
{
    return kJournal;
}

JournalFolder::JournalFolder(std::shared_ptr<const model::OwnFolder> root, QString name, model::OwnFolder own)
    : m_root(std::move(root)), m_name(std::move(name)), m_own(std::make_shared<const model::OwnFolder>(std::move(own))),
      m_lock(*m_own, kLock)
{}

std::unique_ptr<JournalFolder> JournalFolder::create(const QString& root)
{
    if (!QDir().mkpath(root))
        return nullptr;
    const std::shared_ptr<const model::OwnFolder> all = openRoot(root);
    // A window that starts now may take a folder without a lock for one that was left.
    for (int tries = 0; all && tries < kFolderTries; ++tries) {
        const QString name = QUuid::createUuid().toString(QUuid::WithoutBraces);
        if (!all->makeFolder(name))
            return nullptr;
        std::optional<model::OwnFolder> own = all->child(name);
        if (!own)
            continue;
        std::unique_ptr<JournalFolder> folder(new JournalFolder(all, name, std::move(*own)));
        if (folder->m_lock.take() == model::OwnLock::State::Taken && folder->m_own->isAtPath()) {
            folder->m_isLocked = true;
            return folder;
        }
        folder->remove();
    }
    return nullptr;
}

std::vector<std::unique_ptr<JournalFolder>> JournalFolder::abandoned(const QString& root)
{
    std::vector<std::pair<qint64, std::unique_ptr<JournalFolder>>> found;
    const std::shared_ptr<const model::OwnFolder> all = openRoot(root);
    for (const QString& name : all ? all->names() : QStringList()) {
        if (QUuid::fromString(name).isNull())
            continue; // None of ours.
        std::optional<model::OwnFolder> own = all->child(name);
        if (!own)
            continue;
        std::unique_ptr<JournalFolder> folder(new JournalFolder(all, name, std::move(*own)));
        const model::OwnLock::State lock = folder->m_lock.take();
        if (lock == model::OwnLock::State::Held)
            continue;
        folder->m_isLocked = lock == model::OwnLock::State::Taken;
        const std::optional<model::OwnEntry> journal = folder->m_own->entry(kJournal);
        if (!journal)
            folder->remove();
        else if (journal->kind == model::OwnEntry::Kind::File)
            found.emplace_back(journal->modifiedMs, std::move(folder));
    }
    std::ranges::stable_sort(found, std::ranges::greater(), [](const auto& one) { return one.first; });
    std::vector<std::unique_ptr<JournalFolder>> folders;
    folders.reserve(found.size());
    for (auto& [modifiedMs, folder] : found)
        folders.push_back(std::move(folder));
    return folders;
}

bool JournalFolder::remove()
{
    // Last of all the lock: who finds the folder without one finds no journal either.
    m_own->remove(kJournal);
    m_own->remove(kJournal + QStringLiteral(".new"));
    m_lock.release();
    if (!std::exchange(m_isLocked, false))
        m_own->remove(kLock); // The lock of the window that is gone.
    return m_root->removeFolder(m_name) || !m_root->entry(m_name);
}

} // namespace hairpaint::app
