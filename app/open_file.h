// What this window knows of the project's file that it has open: whether it has changed since, and who else has it
// open.
#pragma once

#include <QDateTime>
#include <QLockFile>
#include <QString>

#include <memory>

namespace hairpaint::app {

/// Locks lie in the program's own folder, under what the file is called in full, and free themselves when their window
/// dies. They tell of this user's windows on this machine alone; for all others there is changedOutside(). GUI thread.
class OpenFile
{
public:
    /// A window has that file open, and it is not this one.
    [[nodiscard]] static bool isOpenElsewhere(const QString& path);

    /// This window has just read or written it; empty: it has none open.
    void set(const QString& path);
    [[nodiscard]] const QString& path() const { return m_path; } ///< Empty: never saved.
    /// It is there, but another program has written it since.
    [[nodiscard]] bool changedOutside() const;
    /// It was there, and is no more.
    [[nodiscard]] bool gone() const;

private:
    QString m_path;
    bool m_existed = false;
    qint64 m_size = 0;
    QDateTime m_modified;
    std::unique_ptr<QLockFile> m_lock;
};

} // namespace hairpaint::app
