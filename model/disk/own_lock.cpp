// The file has the lines of a QLockFile, which earlier versions of the program know.
#include "model/disk/own_lock.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QLockFile>
#include <QSysInfo>

#ifdef Q_OS_UNIX
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

#include <utility>

namespace hairpaint::model {

OwnLock::OwnLock(const OwnFolder& folder, QString name) : m_folder(folder), m_name(std::move(name)) {}

OwnLock::~OwnLock()
{
    release();
}

#ifdef Q_OS_UNIX

namespace {

constexpr int kLockTries = 4;
constexpr qint64 kMostLockBytes = 4096;

enum class LockAnswer
{
    Held,
    Other, ///< Somebody has it.
    Unknown
};

LockAnswer lockAnswer(int descriptor)
{
    if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0)
        return LockAnswer::Held;
    return errno == EWOULDBLOCK ? LockAnswer::Other : LockAnswer::Unknown; // Not every network folder can.
}

QByteArray linesOfThisProcess()
{
    const QStringList lines{QString::number(QCoreApplication::applicationPid()),
                            QFileInfo(QCoreApplication::applicationFilePath()).completeBaseName(),
                            QSysInfo::machineHostName(), QString::fromLatin1(QSysInfo::machineUniqueId()),
                            QString::fromLatin1(QSysInfo::bootUniqueId())};
    return (lines.join(QLatin1Char('\n')) + QLatin1Char('\n')).toUtf8();
}

/// Somebody of another machine, or, where the system can't tell (`isFree`: it can), a process that runs.
bool isHeldByLines(int descriptor, bool isFree)
{
    QByteArray text(kMostLockBytes, Qt::Uninitialized);
    const ssize_t count = ::pread(descriptor, text.data(), static_cast<size_t>(text.size()), 0);
    const QList<QByteArray> lines = text.first(count > 0 ? count : 0).split('\n');
    const QByteArray machine = lines.value(3);
    const bool isOurs = !machine.isEmpty()
                            ? machine == QSysInfo::machineUniqueId()
                            : lines.value(2).isEmpty() || lines.value(2) == QSysInfo::machineHostName().toUtf8();
    if (!isOurs)
        return true;
    if (isFree || (!lines.value(4).isEmpty() && lines.value(4) != QSysInfo::bootUniqueId()))
        return false;
    const int process = lines.value(0).toInt();
    return process > 0 && (::kill(process, 0) == 0 || errno == EPERM);
}

} // namespace

OwnLock::State OwnLock::take()
{
    const QByteArray name = QFile::encodeName(m_name);
    for (int tries = 0; tries < kLockTries; ++tries) {
        release();
        constexpr int kSafely = O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC;
        m_descriptor = ::openat(m_folder.descriptor(), name.constData(), O_RDWR | O_CREAT | kSafely, S_IRUSR | S_IWUSR);
        const bool isWritable = m_descriptor >= 0;
        if (!isWritable)
            m_descriptor = ::openat(m_folder.descriptor(), name.constData(), O_RDONLY | kSafely);
        struct stat status = {};
        if (m_descriptor < 0 || ::fstat(m_descriptor, &status) != 0 || !S_ISREG(status.st_mode)) {
            // A link or a pipe under this name is nobody's lock.
            if (!m_folder.remove(m_name))
                break;
            continue;
        }
        const LockAnswer held = lockAnswer(m_descriptor);
        if (held == LockAnswer::Other ||
            (status.st_size > 0 && isHeldByLines(m_descriptor, held == LockAnswer::Held))) {
            (void)::close(std::exchange(m_descriptor, -1));
            return State::Held;
        }
        if (!isWritable)
            return State::Missing;
        // Whoever had it may have removed the file between the two.
        if (::fstat(m_descriptor, &status) != 0 || status.st_nlink == 0)
            continue;
        m_isTaken = true;
        // On a full disk it stays empty, and is a lock all the same.
        const QByteArray lines = linesOfThisProcess();
        if (::ftruncate(m_descriptor, 0) == 0 &&
            ::pwrite(m_descriptor, lines.constData(), static_cast<size_t>(lines.size()), 0) != lines.size())
            [&] { return ::ftruncate(m_descriptor, 0); }();
        return State::Taken;
    }
    release();
    return State::Missing;
}

bool OwnLock::isHeld()
{
    const int descriptor = ::openat(m_folder.descriptor(), QFile::encodeName(m_name).constData(),
                                    O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0)
        return false;
    struct stat status = {};
    const LockAnswer held = lockAnswer(descriptor);
    const bool is =
        ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) &&
        (held == LockAnswer::Other || (status.st_size > 0 && isHeldByLines(descriptor, held == LockAnswer::Held)));
    (void)::close(descriptor);
    return is;
}

void OwnLock::release()
{
    if (m_descriptor < 0)
        return;
    if (std::exchange(m_isTaken, false))
        (void)m_folder.remove(m_name);
    (void)::close(std::exchange(m_descriptor, -1));
}

#else

OwnLock::State OwnLock::take()
{
    release();
    m_file = std::make_unique<QLockFile>(m_folder.pathOf(m_name));
    m_file->setStaleLockTime(0); // A day of thinking does not make a window a dead one.
    if (m_file->tryLock(0)) {
        m_isTaken = true;
        return State::Taken;
    }
    return m_file->error() == QLockFile::LockFailedError ? State::Held : State::Missing;
}

bool OwnLock::isHeld()
{
    const bool is = take() == State::Held;
    release();
    return is;
}

void OwnLock::release()
{
    m_isTaken = false;
    m_file.reset();
}

#endif

} // namespace hairpaint::model
