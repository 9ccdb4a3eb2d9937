// Locks by name, changes by size and time.
#include "app/open_file.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

namespace hairpaint::app {

namespace {

/// Links and spellings of one file have one lock.
QString lockPath(const QString& path)
{
    const QFileInfo file(path);
    const QString whole = file.exists() ? file.canonicalFilePath() : file.absoluteFilePath();
    const QByteArray name = QCryptographicHash::hash(whole.toUtf8(), QCryptographicHash::Sha1).toHex();
    return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + QStringLiteral("/open/") +
           QString::fromLatin1(name) + QStringLiteral(".lock");
}

std::unique_ptr<QLockFile> lockOf(const QString& path)
{
    const QString lock = lockPath(path);
    QDir().mkpath(QFileInfo(lock).absolutePath());
    auto file = std::make_unique<QLockFile>(lock);
    file->setStaleLockTime(0); // As long as its window lives.
    return file;
}

} // namespace

bool OpenFile::isOpenElsewhere(const QString& path)
{
    const std::unique_ptr<QLockFile> lock = lockOf(path);
    // Where no lock can be written, there is none to be found either.
    return !lock->tryLock(0) && lock->error() == QLockFile::LockFailedError;
}

void OpenFile::set(const QString& path)
{
    if (path != m_path || !m_lock) {
        m_lock.reset();
        m_path = path;
        if (!path.isEmpty()) {
            m_lock = lockOf(path);
            (void)m_lock->tryLock(0); // One that another window holds was asked about.
        }
    }
    const QFileInfo file(path);
    m_existed = !path.isEmpty() && file.exists();
    m_size = file.size();
    m_modified = file.lastModified();
}

bool OpenFile::changedOutside() const
{
    const QFileInfo file(m_path);
    return !m_path.isEmpty() && file.exists() && (file.size() != m_size || file.lastModified() != m_modified);
}

bool OpenFile::gone() const
{
    return m_existed && !QFileInfo::exists(m_path);
}

} // namespace hairpaint::app
