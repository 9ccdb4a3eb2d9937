// The file, and its folder, where it appears again after others have replaced it.
#include "app/file_watch.h"

#include <QFileInfo>

namespace hairpaint::app {

namespace {

constexpr int kSettledMs = 200;

} // namespace

FileWatch::FileWatch(QObject* parent) : QObject(parent)
{
    m_soon.setSingleShot(true);
    m_soon.setInterval(kSettledMs);
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, &FileWatch::look);
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, &FileWatch::look);
    connect(&m_soon, &QTimer::timeout, this, [this] {
        watch();
        Q_EMIT maybeChanged();
    });
}

void FileWatch::setPath(const QString& path)
{
    const QStringList watched = m_watcher.files() + m_watcher.directories();
    if (!watched.isEmpty())
        m_watcher.removePaths(watched);
    m_soon.stop();
    m_path = path;
    watch();
}

void FileWatch::watch()
{
    // A file that was replaced is another one to the system.
    const QFileInfo file(m_path);
    if (!m_path.isEmpty() && file.exists() && !m_watcher.files().contains(m_path))
        m_watcher.addPath(m_path);
    const QString folder = file.absolutePath();
    if (!m_path.isEmpty() && QFileInfo::exists(folder) && !m_watcher.directories().contains(folder))
        m_watcher.addPath(folder);
}

void FileWatch::look()
{
    if (!m_path.isEmpty())
        m_soon.start();
}

} // namespace hairpaint::app
