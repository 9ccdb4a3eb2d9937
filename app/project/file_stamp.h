// What a disk says of a file, to know it and its changes by.
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

/// Returns when the disk has answered, so it is not for the GUI thread.
[[nodiscard]] FileStamp stampOf(const QString& path);

/// It is there, and it is not what it was.
[[nodiscard]] bool isChanged(const FileStamp& before, const FileStamp& now);
/// It was there, and is no more.
[[nodiscard]] bool isGone(const FileStamp& before, const FileStamp& now);

} // namespace hairpaint::app
