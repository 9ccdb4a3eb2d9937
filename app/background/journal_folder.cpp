// Folders and their locks.
#include "app/background/journal_folder.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <QUuid>

#include <algorithm>

namespace hairpaint::app {

namespace {

const QString kLock = QStringLiteral("lock");
const QString kJournal = QStringLiteral("journal");

} // namespace

QString JournalFolder::root()
{
    return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + QStringLiteral("/journals");
}

JournalFolder::JournalFolder(const QString& path) : m_path(path), m_lock(path + QLatin1Char('/') + kLock)
{
    m_lock.setStaleLockTime(0); // A day of thinking does not make a window a dead one.
}

std::unique_ptr<JournalFolder> JournalFolder::create(const QString& root)
{
    const QString path = root + QLatin1Char('/') + QUuid::createUuid().toString(QUuid::WithoutBraces);
    // Only its owner may look into it: it holds what is nobody else's business.
    if (!QDir().mkpath(path))
        return nullptr;
    QFile::setPermissions(path, QFileDevice::ReadOwner | QFileDevice::WriteOwner | QFileDevice::ExeOwner);
    std::unique_ptr<JournalFolder> folder(new JournalFolder(path));
    if (!folder->m_lock.tryLock(0)) {
        QDir(path).removeRecursively();
        return nullptr;
    }
    return folder;
}

std::vector<std::unique_ptr<JournalFolder>> JournalFolder::abandoned(const QString& root)
{
    std::vector<std::unique_ptr<JournalFolder>> found;
    for (const QFileInfo& entry : QDir(root).entryInfoList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        if (QUuid::fromString(entry.fileName()).isNull())
            continue; // None of ours.
        std::unique_ptr<JournalFolder> folder(new JournalFolder(entry.absoluteFilePath()));
        if (!folder->m_lock.tryLock(0))
            continue;
        if (QFileInfo::exists(folder->file()))
            found.push_back(std::move(folder));
        else
            folder->remove();
    }
    std::ranges::sort(found, std::ranges::greater(), [](const std::unique_ptr<JournalFolder>& folder) {
        return QFileInfo(folder->file()).lastModified();
    });
    return found;
}

QString JournalFolder::file() const
{
    return m_path + QLatin1Char('/') + kJournal;
}

void JournalFolder::remove()
{
    QFile::remove(file());
    m_lock.unlock();
    QDir(m_path).removeRecursively();
}

} // namespace hairpaint::app
