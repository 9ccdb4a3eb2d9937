// Told by name and by the lock that nobody holds any more.
#include "model/disk/staged_sweep.h"

#include "model/disk/staged_files.h"
#include "model/disk/staged_names.h"

#include <QDir>
#include <QFileInfo>

#include <filesystem>
#include <system_error>

namespace hairpaint::model {

namespace {

/// What was put aside has another name as long as it is in its place too.
bool isElsewhereToo(const QString& path)
{
    std::error_code problem;
    return std::filesystem::hard_link_count(QFileInfo(path).filesystemFilePath(), problem) > 1 && !problem;
}

bool sweepFolder(const QString& path)
{
    const QDir folder(path);
    const QString lock = folder.filePath(StagedFiles::kLockName);
    // Without a lock it may be so new that it has none yet; it is empty then.
    if (QFileInfo::exists(lock) && (isHeldStaged(lock) || !QFile::remove(lock)))
        return false;
    for (const QString& name : folder.entryList(QDir::Files | QDir::Hidden | QDir::NoSymLinks))
        (void)QFile::remove(folder.filePath(name));
    const QDir aside(folder.filePath(StagedFiles::kAsideName));
    for (const QString& name : aside.entryList(QDir::Files | QDir::Hidden | QDir::NoSymLinks))
        if (isElsewhereToo(aside.filePath(name)))
            (void)QFile::remove(aside.filePath(name));
    (void)folder.rmdir(StagedFiles::kAsideName);
    return QDir().rmdir(path);
}

} // namespace

int sweepStaged(const QString& folder)
{
    int swept = 0;
    const QDir place(folder);
    const auto left = [&place](QDir::Filters what) {
        return place.entryList({stagedNamePattern()}, what | QDir::Hidden | QDir::NoSymLinks | QDir::NoDotAndDotDot);
    };
    for (const QString& name : left(QDir::Files))
        if (const QString path = place.filePath(name); !isHeldStaged(path) && QFile::remove(path))
            ++swept;
    for (const QString& name : left(QDir::Dirs))
        if (sweepFolder(place.filePath(name)))
            ++swept;
    return swept;
}

} // namespace hairpaint::model
