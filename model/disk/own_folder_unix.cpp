// By descriptors: every call names a folder that is open and an entry of it, and O_NOFOLLOW.
#include "model/disk/own_folder.h"

#ifdef Q_OS_UNIX

#include "model/values/sentences.h"

#include <cerrno>
#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace hairpaint::model {

namespace {

constexpr mode_t kOwnersFile = S_IRUSR | S_IWUSR;
constexpr mode_t kOwnersFolder = S_IRWXU;

bool isSameFile(const struct stat& one, const struct stat& other)
{
    return one.st_dev == other.st_dev && one.st_ino == other.st_ino;
}

std::optional<struct stat> statusOf(int folder, const QString& name)
{
    struct stat status = {};
    if (::fstatat(folder, QFile::encodeName(name).constData(), &status, AT_SYMLINK_NOFOLLOW) != 0)
        return std::nullopt;
    return status;
}

/// None, with errno, where it is no ordinary file.
int openOrdinary(int folder, const QByteArray& name, int flags)
{
    // Without O_NONBLOCK a pipe would keep it waiting for a writer.
    const int descriptor = ::openat(folder, name.constData(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | flags);
    struct stat status = {};
    if (descriptor < 0 || (::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode)))
        return descriptor;
    (void)::close(descriptor);
    errno = EINVAL;
    return -1;
}

} // namespace

OwnFolder::OwnFolder(QString path, int descriptor) : m_path(std::move(path)), m_descriptor(descriptor) {}

OwnFolder::OwnFolder(OwnFolder&& other) noexcept
    : m_path(std::move(other.m_path)), m_descriptor(std::exchange(other.m_descriptor, -1)),
      m_problem(std::move(other.m_problem))
{}

OwnFolder& OwnFolder::operator=(OwnFolder&& other) noexcept
{
    std::swap(m_path, other.m_path);
    std::swap(m_descriptor, other.m_descriptor);
    std::swap(m_problem, other.m_problem);
    return *this;
}

OwnFolder::~OwnFolder()
{
    if (m_descriptor >= 0)
        (void)::close(m_descriptor);
}

std::optional<OwnFolder> OwnFolder::open(const QString& path)
{
    const int descriptor = ::open(QFile::encodeName(path).constData(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0)
        return std::nullopt;
    return OwnFolder(path, descriptor);
}

std::optional<OwnFolder> OwnFolder::child(const QString& name) const
{
    const int descriptor =
        ::openat(m_descriptor, QFile::encodeName(name).constData(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (descriptor < 0)
        return std::nullopt;
    return OwnFolder(pathOf(name), descriptor);
}

bool OwnFolder::isAtPath() const
{
    struct stat held = {};
    struct stat named = {};
    return ::fstat(m_descriptor, &held) == 0 && ::stat(QFile::encodeName(m_path).constData(), &named) == 0 &&
           isSameFile(held, named);
}

QStringList OwnFolder::names() const
{
    QStringList found;
    // The list has a descriptor of its own: it closes it, and begins where the last one ended.
    const int own = ::openat(m_descriptor, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    DIR* list = own < 0 ? nullptr : ::fdopendir(own);
    if (list == nullptr) {
        if (own >= 0)
            (void)::close(own);
        return found;
    }
    // No other thread reads this list. NOLINTNEXTLINE(concurrency-mt-unsafe)
    while (const dirent* entry = ::readdir(list)) {
        const QString name = QFile::decodeName(static_cast<const char*>(entry->d_name));
        if (name != QLatin1String(".") && name != QLatin1String(".."))
            found += name;
    }
    (void)::closedir(list);
    return found;
}

namespace {

qint64 modifiedMsOf(const struct stat& status)
{
    constexpr qint64 kMsPerSecond = 1000;
    constexpr qint64 kNsPerMs = 1'000'000;
#ifdef Q_OS_DARWIN
    const timespec& time = status.st_mtimespec;
#else
    const timespec& time = status.st_mtim;
#endif
    return time.tv_sec * kMsPerSecond + time.tv_nsec / kNsPerMs;
}

} // namespace

std::optional<OwnEntry> OwnFolder::entry(const QString& name) const
{
    const std::optional<struct stat> status = statusOf(m_descriptor, name);
    if (!status)
        return std::nullopt;
    return OwnEntry{.kind = S_ISREG(status->st_mode)   ? OwnEntry::Kind::File
                            : S_ISDIR(status->st_mode) ? OwnEntry::Kind::Folder
                                                       : OwnEntry::Kind::Other,
                    .size = status->st_size,
                    .modifiedMs = modifiedMsOf(*status),
                    .hasOtherNames = status->st_nlink > 1};
}

bool OwnFolder::isNamed(const QFile& file, const QString& name) const
{
    struct stat held = {};
    const std::optional<struct stat> named = statusOf(m_descriptor, name);
    return named && ::fstat(file.handle(), &held) == 0 && isSameFile(held, *named);
}

bool OwnFolder::openToRead(QFile& file, const QString& name) const
{
    m_problem.clear();
    file.setFileName(pathOf(name));
    const int descriptor = openOrdinary(m_descriptor, QFile::encodeName(name), O_NOFOLLOW);
    if (descriptor < 0) {
        m_problem = errno == EINVAL || errno == ELOOP
                        ? say(QT_TRANSLATE_NOOP("Files", "it is not an ordinary file; choose another"))
                        : readRefusal(qt_error_string(errno));
        return false;
    }
    if (file.open(descriptor, QIODevice::ReadOnly, QFileDevice::AutoCloseHandle))
        return true;
    (void)::close(descriptor);
    m_problem = readRefusal(file.errorString());
    return false;
}

bool OwnFolder::openNew(QFile& file, const QString& name) const
{
    m_problem.clear();
    file.setFileName(pathOf(name));
    const QByteArray encoded = QFile::encodeName(name);
    const auto make = [&] {
        return ::openat(m_descriptor, encoded.constData(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC,
                        kOwnersFile);
    };
    int descriptor = make();
    if (descriptor < 0 && errno == EEXIST && remove(name))
        descriptor = make();
    if (descriptor < 0) {
        m_problem = writeRefusal(qt_error_string(errno));
        return false;
    }
    if (file.open(descriptor, QIODevice::WriteOnly | QIODevice::Unbuffered, QFileDevice::AutoCloseHandle))
        return true;
    (void)::close(descriptor);
    m_problem = writeRefusal(file.errorString());
    return false;
}

bool OwnFolder::makeFolder(const QString& name) const
{
    return ::mkdirat(m_descriptor, QFile::encodeName(name).constData(), kOwnersFolder) == 0;
}

bool OwnFolder::rename(const QString& from, const QString& to) const
{
    return ::renameat(m_descriptor, QFile::encodeName(from).constData(), m_descriptor,
                      QFile::encodeName(to).constData()) == 0;
}

bool OwnFolder::remove(const QString& name) const
{
    return ::unlinkat(m_descriptor, QFile::encodeName(name).constData(), 0) == 0;
}

bool OwnFolder::removeFolder(const QString& name) const
{
    return ::unlinkat(m_descriptor, QFile::encodeName(name).constData(), AT_REMOVEDIR) == 0;
}

void OwnFolder::flush() const
{
    (void)::fsync(m_descriptor);
}

bool OwnFolder::isHeld(const QString& name) const
{
    const int descriptor = openOrdinary(m_descriptor, QFile::encodeName(name), O_NOFOLLOW);
    if (descriptor < 0)
        return true;
    const bool held = ::flock(descriptor, LOCK_EX | LOCK_NB) != 0;
    (void)::close(descriptor);
    return held;
}

std::optional<QByteArray> contentOfOrdinaryFile(const QString& path, qint64 mostBytes)
{
    const int descriptor = openOrdinary(AT_FDCWD, QFile::encodeName(path), 0);
    if (descriptor < 0)
        return std::nullopt;
    QFile file;
    if (!file.open(descriptor, QIODevice::ReadOnly, QFileDevice::AutoCloseHandle)) {
        (void)::close(descriptor);
        return std::nullopt;
    }
    const QByteArray bytes = file.read(mostBytes + 1); // Whatever size it claims.
    return bytes.size() > mostBytes ? std::nullopt : std::optional(bytes);
}

} // namespace hairpaint::model

#endif
