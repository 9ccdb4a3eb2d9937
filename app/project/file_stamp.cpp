// Size and time.
#include "app/project/file_stamp.h"

#include <QDateTime>
#include <QFileInfo>

namespace hairpaint::app {

FileStamp stampOf(const QString& path)
{
    if (path.isEmpty())
        return {};
    const QFileInfo file(path);
    const bool exists = file.exists();
    return {.wholeName = exists ? file.canonicalFilePath() : file.absoluteFilePath(),
            .exists = exists,
            .size = file.size(),
            .modifiedMs = exists ? file.lastModified().toMSecsSinceEpoch() : 0};
}

bool isChanged(const FileStamp& before, const FileStamp& now)
{
    return !before.wholeName.isEmpty() && now.exists &&
           (now.size != before.size || now.modifiedMs != before.modifiedMs);
}

bool isGone(const FileStamp& before, const FileStamp& now)
{
    return before.exists && !now.wholeName.isEmpty() && !now.exists;
}

} // namespace hairpaint::app
