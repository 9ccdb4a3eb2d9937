// Asking, waiting and telling: see the header.
#include "app/exchange/file_work.h"

#include <QFileInfo>
#include <QMessageBox>

namespace hairpaint::app {

FileWork::FileWork(Settings& settings, Jobs& jobs, QWidget& window)
    : QObject(&window), m_settings(settings), m_jobs(jobs), m_window(window), m_dialogs(window, jobs)
{}

QString FileWork::askSavePath(SaveQuestion question, QString* chosenFilter)
{
    question.suggestedPath =
        m_settings.lastFolder() + QLatin1Char('/') + question.suggestedPath + QLatin1Char('.') + question.suffix;
    const QString path = m_dialogs.askSavePath(question, chosenFilter);
    if (!path.isEmpty())
        m_settings.setLastFolder(QFileInfo(path).absolutePath());
    return path;
}

QString FileWork::askOpenPath(const QString& title, const QString& filter)
{
    const QString path = m_dialogs.askOpenPath(title, m_settings.lastFolder(), filter + tr(";;All files (*)"));
    if (!path.isEmpty())
        m_settings.setLastFolder(QFileInfo(path).absolutePath());
    return path;
}

QStringList FileWork::askOpenPaths(const QString& title, const QString& filter)
{
    const QStringList paths = m_dialogs.askOpenPaths(title, m_settings.lastFolder(), filter + tr(";;All files (*)"));
    if (!paths.isEmpty())
        m_settings.setLastFolder(QFileInfo(paths.front()).absolutePath());
    return paths;
}

QString FileWork::askFolder(const QString& title)
{
    const QString folder = m_dialogs.askFolder(title, m_settings.lastFolder());
    if (!folder.isEmpty())
        m_settings.setLastFolder(folder);
    return folder;
}

bool FileWork::write(const Doing& doing, const QString& path, Work<void> work)
{
    if (!change(doing, path, std::move(work)))
        return false;
    Q_EMIT done(tr("%1 written").arg(QFileInfo(path).fileName()));
    return true;
}

bool FileWork::change(const Doing& doing, const QString& path, Work<void> work)
{
    const Awaited<void> awaited = m_jobs.awaitOrLeave<void>(doing, std::move(work));
    const bool failed = awaited.result && !*awaited.result;
    complainOf(awaited.end, failed ? &awaited.result->error() : nullptr, path, model::cannotWrite);
    return awaited.result && !failed;
}

void FileWork::complain(const QString& message)
{
    QMessageBox::warning(&m_window, tr("Hair Paint"), message);
}

void FileWork::complainOf(WorkEnd end, const model::Error* error, const QString& path, model::Phrase phrase)
{
    if (end == WorkEnd::Left)
        complain(phrase(path, model::silentDisk()).value().message);
    else if (end == WorkEnd::Done && error != nullptr)
        complain(error->message);
}

Doing FileWork::readWork(const QString& path)
{
    const QString name = QFileInfo(path).fileName();
    return {.text = tr("Reading %1").arg(name), .whenCancelled = tr("The file '%1' was not read: cancelled").arg(name)};
}

Doing FileWork::writingOf(const QString& path)
{
    const QString name = QFileInfo(path).fileName();
    return {.text = tr("Writing %1").arg(name),
            .whenCancelled = tr("The file '%1' was not written: cancelled").arg(name)};
}

} // namespace hairpaint::app
