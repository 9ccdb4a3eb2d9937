// Locks by name.
#include "app/project/open_file.h"

#include <QCryptographicHash>
#include <QDir>
#include <QStandardPaths>

#include <utility>

namespace hairpaint::app {

namespace {

QString lockName(const QString& wholeName)
{
    const QByteArray name = QCryptographicHash::hash(wholeName.toUtf8(), QCryptographicHash::Sha1).toHex();
    return QString::fromLatin1(name) + QStringLiteral(".lock");
}

} // namespace

struct OpenFile::Lock
{
    model::OwnFolder folder;
    model::OwnLock lock;

    Lock(model::OwnFolder opened, const QString& wholeName)
        : folder(std::move(opened)), lock(folder, lockName(wholeName))
    {}

    /// Null where there is no folder of locks, and none can be made.
    [[nodiscard]] static std::shared_ptr<Lock> of(const QString& wholeName)
    {
        const QString path =
            QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + QStringLiteral("/open");
        QDir().mkpath(path);
        std::optional<model::OwnFolder> folder = model::OwnFolder::open(path);
        return folder ? std::make_shared<Lock>(std::move(*folder), wholeName) : nullptr;
    }
};

bool OpenFile::isOpenElsewhere(const FileStamp& file)
{
    const std::shared_ptr<Lock> lock = Lock::of(file.wholeName);
    // Where no lock can be written, there may be one of a window that is gone.
    return lock && lock->lock.isHeld();
}

void OpenFile::set(const QString& path, const FileStamp& stamp)
{
    if (!m_lock || path != m_path || stamp.wholeName != m_stamp.wholeName) {
        m_lock.reset();
        if (!stamp.wholeName.isEmpty()) {
            m_lock = Lock::of(stamp.wholeName);
            if (m_lock)
                (void)m_lock->lock.take(); // One that another window holds was asked about.
        }
    }
    m_path = path;
    m_stamp = stamp;
}

} // namespace hairpaint::app
