// Writes files whole or not at all; no other code writes any.
#pragma once

#include "model/disk/disk_sync.h"
#include "model/disk/output_path.h"
#include "model/disk/staged_file.h"
#include "model/values/progress.h"
#include "model/values/sentences.h"

#include <QByteArrayView>

namespace hairpaint::model {

/// Writes a file beside `path`, or beside the target of that link, and replaces `path` once every byte is on the
/// disk. Until then, and on any failure, `path` keeps its content. One thread. Errors: clauses for cannotWrite.
class AtomicFile
{
public:
    explicit AtomicFile(const QString& path);

    [[nodiscard]] Checked<void> open();
    /// The first failure is kept for commit(); later calls do nothing.
    void write(QByteArrayView bytes);
    /// Overwrites bytes already written; later writes still append at the end.
    void rewrite(qint64 at, QByteArrayView bytes);
    [[nodiscard]] bool failed() const { return !m_problem.isEmpty(); }
    /// Flushes every byte to the disk, which may take long. Replaces nothing yet.
    [[nodiscard]] Checked<void> flush();
    [[nodiscard]] Checked<void> commit();

private:
    void writeThrough(QByteArrayView bytes);

    Checked<QString> m_target;
    StagedFile m_staged;
    QString m_path; ///< The file itself, links resolved.
    QByteArray m_buffer;
    QString m_problem;
    bool m_isFlushed = false; ///< Since the last write.
};

/// Flushes `file` to the disk, which may take long, then commits it as `path`. If `progress` then returns false,
/// nothing is replaced.
[[nodiscard]] Result<void> commitWanted(AtomicFile& file, const QString& path, const Progress& progress);

/// Writes a whole file in one call.
[[nodiscard]] Checked<void> writeFile(const QString& path, QByteArrayView bytes);
/// The same; replaces nothing if `progress` returns false.
[[nodiscard]] Result<void> writeWanted(const QString& path, QByteArrayView bytes, const Progress& progress);

/// Copies the rest of `from`, from its current position.
[[nodiscard]] Checked<void> copyFile(QFile& from, const QString& path);

/// Flushes an open file to the disk; all of it is there when this succeeds.
[[nodiscard]] Checked<void> flushToDisk(QFileDevice& file);

/// Why the last write to `file` failed, as a clause.
[[nodiscard]] QString writeProblem(const QFileDevice& file);
/// There is none left on a disk, as a clause.
[[nodiscard]] QString noSpace();

} // namespace hairpaint::model
