// Locks by name.
#include "app/project/open_file.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

namespace hairpaint::app {

namespace {

QString lockPath(const QString& wholeName)
{
    const QByteArray name = QCryptographicHash::hash(wholeName.toUtf8(), QCryptographicHash::Sha1).toHex();
    return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + QStringLiteral("/open/") +
           QString::fromLatin1(name) + QStringLiteral(".lock");
}

std::unique_ptr<QLockFile> lockOf(const QString& wholeName)
{
    const QString lock = lockPath(wholeName);
    QDir().mkpath(QFileInfo(lock).absolutePath());
    auto file = std::make_unique<QLockFile>(lock);
    file->setStaleLockTime(0); // As long as its window lives.
    return file;
}

} // namespace

bool OpenFile::isOpenElsewhere(const FileStamp& file)
{
    const std::unique_ptr<QLockFile> lock = lockOf(file.wholeName);
    // Where no lock can be written, there is none to be found either.
    return !lock->tryLock(0) && lock->error() == QLockFile::LockFailedError;
}

void OpenFile::set(const QString& path, const FileStamp& stamp)
{
    if (!m_lock || path != m_path || stamp.wholeName != m_stamp.wholeName) {
        m_lock.reset();
        if (!stamp.wholeName.isEmpty()) {
            m_lock = lockOf(stamp.wholeName);
            (void)m_lock->tryLock(0); // One that another window holds was asked about.
        }
    }
    m_path = path;
    m_stamp = stamp;
}

} // namespace hairpaint::app
