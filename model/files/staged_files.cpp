// Renaming from a folder on the same disk.
#include "model/files/staged_files.h"

#include "model/files/sentences.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <filesystem>
#include <system_error>

namespace hairpaint::model {

namespace {

/// Over what lies there. A clause on what went wrong; empty where nothing did.
QString moveFile(const QString& from, const QString& to)
{
    std::error_code problem;
    std::filesystem::rename(QFileInfo(from).filesystemFilePath(), QFileInfo(to).filesystemFilePath(), problem);
    return problem ? writeRefusal(QString::fromLocal8Bit(problem.message())) : QString();
}

/// Gives it a second name, so that its place is never empty; the first goes where a disk knows no such names.
QString keepFile(const QString& file, const QString& as)
{
    std::error_code problem;
    std::filesystem::create_hard_link(QFileInfo(file).filesystemFilePath(), QFileInfo(as).filesystemFilePath(),
                                      problem);
    return problem ? moveFile(file, as) : QString();
}

} // namespace

StagedFiles::StagedFiles(const QString& folder) : m_folder(folder + QStringLiteral("/hairpaint-XXXXXX")) {}

Result<void> StagedFiles::check(const QString& place) const
{
    if (m_folder.isValid())
        return {};
    return cannotWrite(place, {.text = writeRefusal(m_folder.errorString())});
}

QString StagedFiles::pathFor(const QString& place) const
{
    return m_folder.filePath(QFileInfo(place).fileName());
}

Error StagedFiles::named(Error error, const QString& place) const
{
    error.message.replace(shownPath(pathFor(place)), shownPath(place));
    return error;
}

Result<void> StagedFiles::publish(const QStringList& places) const
{
    // What lies there is put aside first, so that it can be put back.
    if (!QDir(m_folder.path()).mkpath(QStringLiteral("before")))
        return cannotWrite(places.front(), {.text = writeRefusal(qt_error_string())});
    qsizetype aside = 0;
    qsizetype placed = 0;
    QString problem;
    for (; aside < places.size() && problem.isEmpty(); ++aside)
        if (QFileInfo::exists(places[aside]))
            problem = keepFile(places[aside], asideFor(aside));
    for (; placed < places.size() && problem.isEmpty(); ++placed)
        problem = moveFile(pathFor(places[placed]), places[placed]);
    if (problem.isEmpty())
        return {};
    const QString& failed = places[placed > 0 ? placed - 1 : aside - 1];
    for (qsizetype i = 0; i < aside; ++i) {
        if (QFileInfo::exists(asideFor(i)))
            (void)moveFile(asideFor(i), places[i]);
        else if (i < placed)
            (void)QFile::remove(places[i]);
    }
    return cannotWrite(failed, {.text = problem});
}

QString StagedFiles::asideFor(qsizetype number) const
{
    return m_folder.filePath(QStringLiteral("before/%1").arg(number));
}

} // namespace hairpaint::model
