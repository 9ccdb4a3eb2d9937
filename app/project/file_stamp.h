// Size, time and identity of a file on its disk, by which it and its changes are recognised.
#pragma once

#include <QString>

namespace hairpaint::app {

struct FileStamp
{
    QString wholeName; ///< The same for all links to a file and spellings of its path. Empty: nothing is known.
    bool exists = false;
    qint64 size = 0;
    qint64 modifiedMs = 0; ///< Since 1970, UTC: the same in every time zone.
};

/// Blocks until the disk answers; not for the GUI thread.
[[nodiscard]] FileStamp stampOf(const QString& path);

/// Whether it exists and differs from what it was.
[[nodiscard]] bool isChanged(const FileStamp& before, const FileStamp& now);
/// Whether it existed and no longer does.
[[nodiscard]] bool isGone(const FileStamp& before, const FileStamp& now);

} // namespace hairpaint::app
