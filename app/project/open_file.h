// The project's file that this window has open: as it was when it was last read or written, and a lock for other
// windows.
#pragma once

#include "app/project/file_stamp.h"
#include "model/disk/own_lock.h"
#include <QLockFile>

#include <memory>

namespace hairpaint::app {

/// Locks lie in the program's own folder, under what the file is called in full, and free themselves when their window
/// dies. They tell of this user's windows on this machine alone; for all others there are stamps. Never asks the file's
/// disk, which may not answer. GUI thread.
class OpenFile
{
public:
    /// A window has that file open, and it is not this one.
    [[nodiscard]] static bool isOpenElsewhere(const FileStamp& file);

    /// This window has just read or written it; an empty path: it has none open. A stamp may follow.
    void set(const QString& path, const FileStamp& stamp);
    [[nodiscard]] const QString& path() const { return m_path; } ///< Empty: never saved.
    [[nodiscard]] const FileStamp& stamp() const { return m_stamp; }

private:
    QString m_path;
    FileStamp m_stamp;
    struct Lock;
    std::shared_ptr<Lock> m_lock;
};

} // namespace hairpaint::app
