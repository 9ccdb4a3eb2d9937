// Projects: what opens can be saved, and saved again it has the same bytes; what does not open can be repaired or is
// refused, and what a repair gives can be saved.
#include "model/files/project_file.h"
#include "model/repair/project_repair.h"
#include "tests/fuzz/made_archive.h"

using namespace hairpaint;

namespace {

QByteArray saved(const model::Project& project)
{
    const QString path = fuzz::scratchPath(QStringLiteral("saved.hairpaint"));
    return model::saveProject(project, path, {}) ? test::readBytes(path) : QByteArray();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    fuzz::Input input(data, size);
    const QByteArray bytes = fuzz::archiveOf(input, "application/x-hairpaint");
    const QString path = fuzz::scratchFile(QStringLiteral("input.hairpaint"), bytes);
    if (const model::Result<model::Project> project = model::loadProject(path)) {
        const QByteArray once = saved(*project);
        fuzz::require(!once.isEmpty());
        const model::Result<model::Project> again =
            model::loadProject(fuzz::scratchPath(QStringLiteral("saved.hairpaint")));
        fuzz::require(again && saved(*again) == once);
        return 0;
    }
    if (const model::Result<model::RepairedProject> repaired = model::repairProject(path))
        fuzz::require(!saved(repaired->project).isEmpty());
    fuzz::require(test::readBytes(path) == bytes);
    return 0;
}
