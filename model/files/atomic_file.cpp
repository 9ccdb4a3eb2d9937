// Checked writing through QSaveFile.
#include "model/files/atomic_file.h"

#include <QFile>
#include <QFileInfo>
#include <QStorageInfo>

#include <algorithm>
#include <filesystem>
#include <system_error>

#ifdef Q_OS_UNIX
#include <cerrno>
#include <fcntl.h>
#include <unistd.h>
#endif

namespace hairpaint::model {

namespace {

constexpr qsizetype kBufferBytes = 1 << 18;
constexpr qsizetype kMostAtOnce = 1 << 23;

QString noSpace()
{
    return say(QT_TRANSLATE_NOOP("Files", "there is no space left on its disk; make room there and try again"));
}

/// Some file systems find out only now that a byte has no place. Empty where all is well.
QString syncProblem([[maybe_unused]] const QFileDevice& file)
{
#ifdef Q_OS_UNIX
    if (::fsync(file.handle()) != 0 && errno != EINVAL && errno != ENOTSUP && errno != EROFS)
        return errno == ENOSPC ? noSpace() : writeRefusal(qt_error_string(errno));
#endif
    return {};
}

/// Has the disk begin with bytes that commit() will wait for, while more are written; a hint, which may do nothing.
void beginFlush([[maybe_unused]] const QFileDevice& file, [[maybe_unused]] qint64 at, [[maybe_unused]] qint64 count)
{
#ifdef Q_OS_LINUX
    if (count == kMostAtOnce)
        (void)::sync_file_range(file.handle(), at, count, SYNC_FILE_RANGE_WRITE);
#endif
}

/// So that a new name outlives a power cut; not every file system can, and the file itself is safe by now.
void flushFolder([[maybe_unused]] const QString& folder)
{
#ifdef Q_OS_UNIX
    const int descriptor = ::open(QFile::encodeName(folder).constData(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0)
        return;
    (void)::fsync(descriptor);
    (void)::close(descriptor);
#endif
}

} // namespace

QString writeProblem(const QFileDevice& file)
{
    // Not every system has an error of its own for a full disk.
    constexpr qint64 kHardlyAnything = 4096;
    const QStorageInfo disk(QFileInfo(file.fileName()).absolutePath());
    const bool isFull = file.error() == QFileDevice::ResourceError ||
                        (disk.isValid() && disk.isReady() && disk.bytesAvailable() < kHardlyAnything);
    if (isFull)
        return noSpace();
    // A file that takes a part of what it was given has no error to tell of.
    return file.error() == QFileDevice::NoError
               ? say(QT_TRANSLATE_NOOP("Files", "only a part of it could be written; check that its disk has room"))
               : writeRefusal(file.errorString());
}

AtomicFile::AtomicFile(const QString& path) : m_file(path) {}

Checked<void> AtomicFile::open()
{
    if (Checked<void> writable = checkWritable(m_file.fileName()); !writable)
        return writable;
    // QSaveFile commits also where flushing its own buffer failed, so it gets none.
    if (!m_file.open(QIODevice::WriteOnly | QIODevice::Unbuffered))
        return refuse(writeRefusal(m_file.errorString()));
    return {};
}

void AtomicFile::write(QByteArrayView bytes)
{
    if (m_buffer.size() + bytes.size() < kBufferBytes) {
        m_buffer.append(bytes.data(), bytes.size());
        return;
    }
    writeThrough(m_buffer);
    m_buffer.clear();
    writeThrough(bytes);
}

void AtomicFile::writeThrough(QByteArrayView bytes)
{
    while (!bytes.isEmpty() && !failed()) {
        // A disk that is filling up takes a part, and says why only when asked again.
        const qint64 at = m_file.pos();
        const qint64 written = m_file.write(bytes.data(), std::min(bytes.size(), kMostAtOnce));
        if (written <= 0) {
            m_problem = writeProblem(m_file);
            continue;
        }
        beginFlush(m_file, at, written);
        bytes = bytes.sliced(static_cast<qsizetype>(written));
    }
}

void AtomicFile::rewrite(qint64 at, QByteArrayView bytes)
{
    writeThrough(m_buffer);
    m_buffer.clear();
    const qint64 end = m_file.pos();
    if (!failed() && !m_file.seek(at))
        m_problem = writeProblem(m_file);
    writeThrough(bytes);
    if (!failed() && !m_file.seek(end))
        m_problem = writeProblem(m_file);
}

Checked<void> AtomicFile::commit()
{
    writeThrough(m_buffer);
    if (!failed())
        m_problem = syncProblem(m_file);
    if (failed())
        return refuse(m_problem);
    const QString folder = QFileInfo(m_file.fileName()).absolutePath();
    if (!m_file.commit())
        return refuse(writeProblem(m_file));
    flushFolder(folder);
    return {};
}

Checked<void> flushToDisk(QFileDevice& file)
{
    if (!file.flush())
        return refuse(writeProblem(file));
    if (const QString problem = syncProblem(file); !problem.isEmpty())
        return refuse(problem);
    return {};
}

bool replaceFile(const QString& from, const QString& to)
{
    std::error_code problem;
    std::filesystem::rename(from.toStdU16String(), to.toStdU16String(), problem);
    return !problem;
}

Checked<void> writeFile(const QString& path, QByteArrayView bytes)
{
    AtomicFile file(path);
    if (Checked<void> opened = file.open(); !opened)
        return opened;
    file.write(bytes);
    return file.commit();
}

} // namespace hairpaint::model
