// Hears when a file is written, replaced or removed, by whomever.
#pragma once

#include <QFileSystemWatcher>
#include <QObject>
#include <QString>
#include <QTimer>

namespace hairpaint::app {

/// Systems tell of many changes at once, and of none in some network folders; look() asks for a look in any case. GUI
/// thread.
class FileWatch : public QObject
{
    Q_OBJECT
public:
    explicit FileWatch(QObject* parent = nullptr);

    void setPath(const QString& path); ///< Empty: nothing is watched.
    void look();

Q_SIGNALS:
    void maybeChanged(); ///< It is worth a look, soon after the last of the changes.

private:
    void watch();

    QString m_path;
    QFileSystemWatcher m_watcher;
    QTimer m_soon;
};

} // namespace hairpaint::app
