// fsync of files and of folders; rename replaces.
#include "model/disk/disk_sync.h"

#ifdef Q_OS_UNIX

#include "model/disk/atomic_file.h"

#include <QFile>

#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <system_error>
#include <unistd.h>

namespace hairpaint::model {

QString syncProblem(const QFileDevice& file)
{
    if (::fsync(file.handle()) != 0 && errno != EINVAL && errno != ENOTSUP && errno != EROFS)
        return errno == ENOSPC ? noSpace() : writeRefusal(qt_error_string(errno));
    return {};
}

void beginFlush([[maybe_unused]] const QFileDevice& file, [[maybe_unused]] qint64 at, [[maybe_unused]] qint64 count)
{
#ifdef Q_OS_LINUX
    (void)::sync_file_range(file.handle(), at, count, SYNC_FILE_RANGE_WRITE);
#endif
}

void flushFolder(const QString& folder)
{
    const int descriptor = ::open(QFile::encodeName(folder).constData(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0)
        return;
    (void)::fsync(descriptor);
    (void)::close(descriptor);
}

bool replaceFile(const QString& from, const QString& to)
{
    std::error_code problem;
    std::filesystem::rename(from.toStdU16String(), to.toStdU16String(), problem);
    return !problem;
}

bool deleteFile(const QString& path)
{
    return QFile::remove(path);
}

} // namespace hairpaint::model

#endif
