// The file, and its folder, where it appears again after others have replaced it.
#include "app/project/file_watch.h"

#include <QFileInfo>

namespace hairpaint::app {

namespace {

constexpr int kSettledMs = 200;

} // namespace

FileWatch::FileWatch(Jobs& jobs, QObject* parent) : QObject(parent), m_jobs(jobs)
{
    m_soon.setSingleShot(true);
    m_soon.setInterval(kSettledMs);
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, &FileWatch::look);
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, &FileWatch::look);
    connect(&m_soon, &QTimer::timeout, this, &FileWatch::ask);
}

void FileWatch::setPath(const QString& path)
{
    const QStringList watched = m_watcher.files() + m_watcher.directories();
    if (!watched.isEmpty())
        m_watcher.removePaths(watched);
    m_soon.stop();
    m_path = path;
    m_isAsked = false;
    ++m_pathNumber;
    if (!path.isEmpty())
        ask();
}

void FileWatch::ask()
{
    if (m_isAsked)
        return m_soon.start(); // The last question waits for its answer yet.
    m_isAsked = true;
    m_jobs.ask<FileStamp>([path = m_path] { return stampOf(path); }, this,
                          [this, number = m_pathNumber](const FileStamp& now) {
                              if (number != m_pathNumber)
                                  return;
                              m_isAsked = false;
                              watch(now);
                              Q_EMIT looked(now);
                          });
}

void FileWatch::watch(const FileStamp& now)
{
    bool isNew = false;
    const auto add = [this, &isNew](const QString& path, const QStringList& watched) {
        isNew = (!watched.contains(path) && m_watcher.addPath(path)) || isNew;
    };
    // A file that was replaced is another one to the system.
    if (now.exists)
        add(m_path, m_watcher.files());
    add(QFileInfo(m_path).absolutePath(), m_watcher.directories());
    if (isNew)
        look(); // It may have changed before it was watched.
}

void FileWatch::look()
{
    if (!m_path.isEmpty())
        m_soon.start();
}

} // namespace hairpaint::app
