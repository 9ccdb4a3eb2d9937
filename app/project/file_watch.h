// Reports when any program writes, replaces or removes a file.
#pragma once

#include "app/background/jobs.h"
#include "app/project/file_stamp.h"

#include <QFileSystemWatcher>
#include <QObject>
#include <QString>
#include <QTimer>

namespace hairpaint::app {

/// Systems tell of many changes at once, and of none in some network folders; look() asks for a look in any case. The
/// disk is asked on another thread, and where it does not answer nothing is heard. GUI thread.
class FileWatch : public QObject
{
    Q_OBJECT
public:
    explicit FileWatch(Jobs& jobs, QObject* parent = nullptr);

    void setPath(const QString& path); ///< Empty: nothing is watched.
    void look();
    [[nodiscard]] bool isLooking() const
    {
        return m_isAsked || m_soon.isActive();
    } ///< Also true where a look is about to begin.

Q_SIGNALS:
    void looked(const FileStamp& now); ///< Once for a path, then soon after the last of some changes.

private:
    void ask();
    void watch(const FileStamp& now);

    Jobs& m_jobs;
    QString m_path;
    QFileSystemWatcher m_watcher;
    QTimer m_soon;
    int m_pathNumber = 0; ///< Number of m_path; answers for former paths are dropped by it.
    bool m_isAsked = false;
};

} // namespace hairpaint::app
