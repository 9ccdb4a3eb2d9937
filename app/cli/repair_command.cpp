// `hairpaint repair`: what can be read of a damaged project, as a new one.
#include "app/cli/command.h"
#include "model/files/project_file.h"
#include "model/repair/project_repair.h"

namespace hairpaint::app {

ExitCode runRepair(const QStringList& arguments)
{
    constexpr const char* kName = "repair";
    QCommandLineParser parser;
    const std::optional<QStringList> files = parse(parser, kName, arguments, 1);
    if (!files)
        return ExitCode::WrongUsage;
    const QString output = parser.value(QStringLiteral("o"));
    if (!isProjectName(output))
        return wrongUsage(kName, CommandLine::tr("-o takes a name that ends in .hairpaint"));
    if (const model::Result<void> free = checkOutput(output, *files); !free)
        return failed(free.error());
    const model::Result<model::RepairedProject> repaired = model::repairProject(files->front());
    if (!repaired)
        return failed(repaired.error());
    if (const model::Result<void> saved = model::saveProject(repaired->project, output, {}); !saved)
        return failed(saved.error());
    if (repaired->losses.isEmpty())
        return printOut(QStringList{CommandLine::tr("Nothing was lost.")});
    return printOut(repaired->losses);
}

} // namespace hairpaint::app
