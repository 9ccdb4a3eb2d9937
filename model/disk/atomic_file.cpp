// Checked writing.
#include "model/disk/atomic_file.h"

#include <QFile>
#include <QFileInfo>
#include <QStorageInfo>

#include <algorithm>

namespace hairpaint::model {

namespace {

constexpr qsizetype kBufferBytes = 1 << 18;
constexpr qsizetype kMostAtOnce = 1 << 23;

/// Not every system has an error of its own for a full disk.
bool isDiskFull(const QString& path)
{
    constexpr qint64 kHardlyAnything = 4096;
    const QStorageInfo disk(QFileInfo(path).path());
    return disk.isValid() && disk.isReady() && disk.bytesAvailable() < kHardlyAnything;
}

} // namespace

QString noSpace()
{
    return say(QT_TRANSLATE_NOOP("Files", "there is no space left on its disk; make room there and try again"));
}

QString writeProblem(const QFileDevice& file)
{
    if (file.error() == QFileDevice::ResourceError || isDiskFull(file.fileName()))
        return noSpace();
    // A file that takes a part of what it was given has no error to tell of.
    return file.error() == QFileDevice::NoError
               ? say(QT_TRANSLATE_NOOP("Files", "only a part of it could be written; check that its disk has room"))
               : writeRefusal(file.errorString());
}

AtomicFile::AtomicFile(const QString& path)
    : m_target(outputPath(path)), m_staged(m_target.value_or(path)), m_path(m_target.value_or(path))
{}

Checked<void> AtomicFile::open()
{
    if (!m_target)
        return tl::unexpected(m_target.error());
    if (!m_staged.open())
        return refuse(writeRefusal(m_staged.file().errorString()));
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
    QFile& file = m_staged.file();
    while (!bytes.isEmpty() && !failed()) {
        // A disk that is filling up takes a part, and says why only when asked again.
        const qint64 at = file.pos();
        const qint64 written = file.write(bytes.data(), std::min(bytes.size(), kMostAtOnce));
        if (written <= 0) {
            m_problem = writeProblem(file);
            continue;
        }
        if (written == kMostAtOnce)
            beginFlush(file, at, written);
        m_isFlushed = false;
        bytes = bytes.sliced(static_cast<qsizetype>(written));
    }
}

void AtomicFile::rewrite(qint64 at, QByteArrayView bytes)
{
    QFile& file = m_staged.file();
    writeThrough(m_buffer);
    m_buffer.clear();
    const qint64 end = file.pos();
    if (!failed() && !file.seek(at))
        m_problem = writeProblem(file);
    writeThrough(bytes);
    if (!failed() && !file.seek(end))
        m_problem = writeProblem(file);
}

Checked<void> AtomicFile::flush()
{
    writeThrough(m_buffer);
    m_buffer.clear();
    if (!failed() && !m_isFlushed)
        m_problem = syncProblem(m_staged.file());
    if (failed())
        return refuse(m_problem);
    m_isFlushed = true;
    return {};
}

Checked<void> AtomicFile::commit()
{
    if (Checked<void> flushed = flush(); !flushed)
        return flushed;
    if (!m_staged.publish())
        return refuse(isDiskFull(m_path) ? noSpace() : m_staged.problem());
    flushFolder(QFileInfo(m_path).path());
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

Result<void> commitWanted(AtomicFile& file, const QString& path, const Progress& progress)
{
    if (const Checked<void> flushed = file.flush(); !flushed)
        return cannotWrite(path, flushed.error());
    if (progress && !progress(1.0))
        return cancelled(path);
    if (const Checked<void> written = file.commit(); !written)
        return cannotWrite(path, written.error());
    return {};
}

Checked<void> copyFile(QFile& from, const QString& path)
{
    constexpr qint64 kCopiedBytes = 1 << 20;
    AtomicFile copy(path);
    if (Checked<void> opened = copy.open(); !opened)
        return opened;
    for (QByteArray piece = from.read(kCopiedBytes); !piece.isEmpty(); piece = from.read(kCopiedBytes))
        copy.write(piece);
    if (from.error() != QFileDevice::NoError)
        return refuse(readRefusal(from.errorString()));
    return copy.commit();
}

Result<void> writeWanted(const QString& path, QByteArrayView bytes, const Progress& progress)
{
    AtomicFile file(path);
    if (const Checked<void> opened = file.open(); !opened)
        return cannotWrite(path, opened.error());
    file.write(bytes);
    return commitWanted(file, path, progress);
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
