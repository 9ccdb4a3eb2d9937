// Renaming from a folder on the same disk.
#include "model/files/staged_files.h"

#include "model/files/sentences.h"

#include <QFileInfo>

#include <filesystem>
#include <system_error>

namespace hairpaint::model {

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
    for (const QString& place : places) {
        std::error_code problem;
        std::filesystem::rename(QFileInfo(pathFor(place)).filesystemFilePath(), QFileInfo(place).filesystemFilePath(),
                                problem);
        if (problem)
            return cannotWrite(place, {.text = writeRefusal(QString::fromLocal8Bit(problem.message()))});
    }
    return {};
}

} // namespace hairpaint::model
