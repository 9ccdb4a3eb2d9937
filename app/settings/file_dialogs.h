// Asks for files and folders; nothing else opens a file dialog.
#pragma once

#include "app/background/jobs.h"

#include <QString>
#include <QStringList>

class QWidget;

namespace hairpaint::app {

/// That folder, or what is nearest to it: the innermost of the folders around it that is there and may be written to,
/// else the user's documents, else their home. Asks the disk, which may not answer; any thread.
[[nodiscard]] QString nearestFolder(const QString& wanted);

struct SaveQuestion
{
    QString title;
    QString suggestedPath;
    QString filter;
    QString suffix; ///< "png"; added, or the chosen filter's, where the name ends in none of those that are known.
    QStringList otherSuffixes = {}; ///< Known besides those of the filters.
};

/// File dialogs over `window`. Each begins in nearestFolder() of the one it is given. What is chosen comes back; empty
/// where cancelled. GUI thread, blocking.
class FileDialogs
{
public:
    FileDialogs(QWidget& window, Jobs& jobs) : m_window(window), m_jobs(jobs) {}

    /// Before a file that is there is replaced, asks, and for the name with which it will be written. `filter`, where
    /// given, becomes the part of question.filter that is chosen.
    [[nodiscard]] QString askSavePath(const SaveQuestion& question, QString* filter = nullptr);
    [[nodiscard]] QString askOpenPath(const QString& title, const QString& folder, const QString& filter);
    [[nodiscard]] QStringList askOpenPaths(const QString& title, const QString& folder, const QString& filter);
    [[nodiscard]] QString askFolder(const QString& title, const QString& folder);

private:
    [[nodiscard]] QString begin(const QString& folder);

    QWidget& m_window;
    Jobs& m_jobs;
};

} // namespace hairpaint::app
