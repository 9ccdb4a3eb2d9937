// Writes files whole or not at all; no other code writes any.
#pragma once

#include "model/disk/output_place.h"
#include "model/disk/staged_file.h"
#include "model/values/progress.h"
#include "model/values/sentences.h"

#include <QByteArrayView>

namespace hairpaint::model {

/// A file beside `path`, or beside what that is a link to, that replaces it once every byte is known to lie on the
/// disk; until then, and where anything fails, `path` keeps what it held. One thread. Errors: clauses for cannotWrite.
class AtomicFile
{
public:
    explicit AtomicFile(const QString& path);

    [[nodiscard]] Checked<void> open();
    /// Remembers the first failure, for commit, and does nothing after it.
    void write(QByteArrayView bytes);
    /// Over bytes that were written before; what is written later follows the last of all.
    void rewrite(qint64 at, QByteArrayView bytes);
    [[nodiscard]] bool failed() const { return !m_problem.isEmpty(); }
    /// Has every byte lie on the disk, which may take long; nothing has been replaced yet.
    [[nodiscard]] Checked<void> flush();
    [[nodiscard]] Checked<void> commit();

private:
    void writeThrough(QByteArrayView bytes);

    Checked<QString> m_place;
    StagedFile m_staged;
    QString m_path; ///< The file itself, links resolved.
    QByteArray m_buffer;
    QString m_problem;
    bool m_isFlushed = false; ///< Since the last write.
};

/// Commits `file`, which is to be `path`, unless `progress` says no once every byte lies on the disk, which may have
/// taken long: then nothing is replaced.
[[nodiscard]] Result<void> commitWanted(AtomicFile& file, const QString& path, const Progress& progress);

/// All of a file at once.
[[nodiscard]] Checked<void> writeFile(const QString& path, QByteArrayView bytes);
/// The same, unless `progress` says no meanwhile.
[[nodiscard]] Result<void> writeWanted(const QString& path, QByteArrayView bytes, const Progress& progress);

/// What is left to read of `from`.
[[nodiscard]] Checked<void> copyFile(QFile& from, const QString& path);

/// Everything written to an open file lies on its disk when this returns well.
[[nodiscard]] Checked<void> flushToDisk(QFileDevice& file);
/// Replaces one file by another: at any moment the name leads to the former or to the new one, whole.
[[nodiscard]] bool replaceFile(const QString& from, const QString& to);

/// Why the last write to `file` failed, as a clause.
[[nodiscard]] QString writeProblem(const QFileDevice& file);

} // namespace hairpaint::model
