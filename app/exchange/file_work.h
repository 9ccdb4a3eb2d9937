// Files of other programs in the window: asks for, reads and writes them with progress, and reports errors.
#pragma once

#include "app/background/jobs.h"
#include "app/settings/file_dialogs.h"
#include "app/settings/settings.h"
#include "model/values/sentences.h"
#include "view/dialogs/help_dialog.h"

#include <QObject>

namespace hairpaint::app {

/// Shows file dialogs, progress and message boxes over `window`. What a disk or a network folder does not answer is
/// left to itself a while after Cancel, so all work owns what it uses. GUI thread, blocking.
class FileWork : public QObject
{
    Q_OBJECT
public:
    FileWork(Settings& settings, Jobs& jobs, QWidget& window);

    /// All begin in the last folder, and remember the one that is chosen; empty where cancelled.
    /// `question.suggestedPath`: a name without folder and ending; see FileDialogs::askSavePath.
    [[nodiscard]] QString askSavePath(SaveQuestion question, QString* chosenFilter = nullptr);
    [[nodiscard]] QString askOpenPath(const QString& title, const QString& filter);
    [[nodiscard]] QStringList askOpenPaths(const QString& title, const QString& filter);
    [[nodiscard]] QString askFolder(const QString& title);

    /// Reads the file `path`. None if it failed, which has been reported, or was cancelled.
    template<typename T>
    [[nodiscard]] std::optional<T> read(const QString& path, Work<T> work);
    /// Writes the file or folder `path` and reports that; false if it failed, which has been reported, or was
    /// cancelled.
    bool write(const QString& path, Work<void> work) { return write(writingOf(path), path, std::move(work)); }
    bool write(const Doing& doing, const QString& path, Work<void> work);
    /// The same, where what is done has words of its own, and nothing is told when it is.
    bool change(const Doing& doing, const QString& path, Work<void> work);

    [[nodiscard]] static Doing writingOf(const QString& path);
    void tell(const QString& message) { Q_EMIT done(message); }
    void complain(const QString& message);
    void announce(QDialog& dialog, view::HelpDialog::Topic topic) { Q_EMIT dialogMade(dialog, topic); }
    [[nodiscard]] QWidget& window() const { return m_window; }
    [[nodiscard]] Jobs& jobs() const { return m_jobs; }
    [[nodiscard]] Settings& settings() const { return m_settings; }

Q_SIGNALS:
    void done(const QString& message); ///< For the status bar.
    /// About to be shown; the help has a page on it.
    void dialogMade(QDialog& dialog, hairpaint::view::HelpDialog::Topic topic);

private:
    [[nodiscard]] static Doing readWork(const QString& path);
    /// Whether there is no error to report: it succeeded or was cancelled.
    void complainOf(WorkEnd end, const model::Error* error, const QString& path, model::Phrase phrase);

    Settings& m_settings;
    Jobs& m_jobs;
    QWidget& m_window;
    FileDialogs m_dialogs;
};

template<typename T>
std::optional<T> FileWork::read(const QString& path, Work<T> work)
{
    Awaited<T> awaited = m_jobs.awaitOrLeave<T>(readWork(path), std::move(work));
    const bool failed = awaited.result && !*awaited.result;
    complainOf(awaited.end, failed ? &awaited.result->error() : nullptr, path, model::cannotOpen);
    if (awaited.end != WorkEnd::Done || failed)
        return std::nullopt;
    return std::move(**awaited.result);
}

} // namespace hairpaint::app
