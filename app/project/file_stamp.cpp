// Size and time.
#include "app/project/file_stamp.h"

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
            .modified = file.lastModified()};
}

bool isChanged(const FileStamp& before, const FileStamp& now)
{
    return !before.wholeName.isEmpty() && now.exists && (now.size != before.size || now.modified != before.modified);
}

bool isGone(const FileStamp& before, const FileStamp& now)
{
    return before.exists && !now.wholeName.isEmpty() && !now.exists;
}

} // namespace hairpaint::app
