// Told by name and by the lock that nobody holds any more.
#include "model/disk/staged_sweep.h"

#include "model/disk/own_folder.h"
#include "model/disk/staged_files.h"
#include "model/disk/staged_names.h"

#include <QDir>

namespace hairpaint::model {

namespace {

bool isFile(const std::optional<OwnEntry>& entry)
{
    return entry && entry->kind == OwnEntry::Kind::File;
}

bool sweepFolder(const OwnFolder& parent, const QString& name)
{
    const QString lock = StagedFiles::kLockName;
    {
        const std::optional<OwnFolder> folder = parent.child(name);
        // Without a lock it may be so new that it has none yet; it is empty then.
        if (!folder || (folder->entry(lock) && (folder->isHeld(lock) || !folder->remove(lock))))
            return false;
        for (const QString& file : folder->names())
            if (isFile(folder->entry(file)))
                folder->remove(file);
        if (const std::optional<OwnFolder> aside = folder->child(StagedFiles::kAsideName))
            for (const QString& file : aside->names())
                // What was put aside has another name as long as it is not replaced.
                if (const std::optional<OwnEntry> entry = aside->entry(file); isFile(entry) && entry->hasOtherNames)
                    aside->remove(file);
        folder->removeFolder(StagedFiles::kAsideName);
    }
    return parent.removeFolder(name);
}

} // namespace

int sweepStaged(const QString& folder)
{
    int swept = 0;
    const std::optional<OwnFolder> parent = OwnFolder::open(folder);
    if (!parent)
        return swept;
    for (const QString& name : parent->names()) {
        if (!QDir::match(stagedNamePattern(), name))
            continue;
        const std::optional<OwnEntry> entry = parent->entry(name);
        const bool isSwept = isFile(entry)
                                 ? !parent->isHeld(name) && parent->remove(name)
                                 : entry && entry->kind == OwnEntry::Kind::Folder && sweepFolder(*parent, name);
        swept += isSwept ? 1 : 0;
    }
    return swept;
}

} // namespace hairpaint::model
