// Staged beside their targets, then renamed together.
#include "model/exporting/side_files.h"

#include "model/disk/atomic_file.h"
#include "model/disk/staged_files.h"

#include <QFileInfo>
#include <QStringList>

namespace hairpaint::model {

Result<void> writeWithSideFiles(const QString& path, const std::vector<SideFile>& sides,
                                const std::function<Result<void>(const QString& staged)>& write)
{
    if (sides.empty())
        return write(path);
    QStringList targets{path};
    for (const SideFile& side : sides)
        targets += side.path;
    for (const QString& target : targets)
        if (const Checked<void> writable = checkWritable(target); !writable)
            return cannotWrite(target, writable.error());
    StagedFiles staged(QFileInfo(path).path());
    if (Result<void> ready = staged.check(path); !ready)
        return ready;
    for (const SideFile& side : sides)
        if (const Checked<void> written = writeFile(staged.pathFor(side.path), side.bytes); !written)
            return cannotWrite(side.path, written.error());
    if (const Result<void> written = write(staged.pathFor(path)); !written)
        return tl::unexpected(staged.named(written.error(), path));
    return staged.publish(targets);
}

} // namespace hairpaint::model
