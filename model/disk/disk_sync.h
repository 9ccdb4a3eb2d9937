// What each system has of its own for putting files on the disk and replacing them. Any thread; may take long.
#pragma once

#include <QFileDevice>

namespace hairpaint::model {

/// Waits until all that was written to an open file is on the disk. Some file systems find out only now that there is
/// no room for a byte. Returns why it failed, as a clause; empty where all is well.
[[nodiscard]] QString syncProblem(const QFileDevice& file);
/// Has the disk begin with bytes that syncProblem() will wait for, while more are written; a hint, which may do
/// nothing.
void beginFlush(const QFileDevice& file, qint64 at, qint64 count);
/// So that a new name outlives a power cut; not every file system can, and the file itself is safe by then.
void flushFolder(const QString& folder);
/// Replaces one file by another: at any moment the name refers to the old or the new file, complete.
[[nodiscard]] bool replaceFile(const QString& from, const QString& to);
/// Deletes a file; on Windows also one that a scanner, or a thread of ours, looks into just now.
[[nodiscard]] bool deleteFile(const QString& path);

} // namespace hairpaint::model
