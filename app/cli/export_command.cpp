// `hairpaint export`: the hair as curves.
#include "app/cli/command.h"
#include "app/cli/settled_hair.h"
#include "model/files/hair_file.h"
#include "model/files/project_file.h"

namespace hairpaint::app {

ExitCode runExport(const QStringList& arguments)
{
    constexpr const char* kName = "export";
    QCommandLineParser parser;
    parser.addOptions({{{QStringLiteral("o"), QStringLiteral("output")}, {}, QStringLiteral("file")},
                       {QStringLiteral("settle"), {}, QStringLiteral("seconds")},
                       {QStringLiteral("hairs"), {}, QStringLiteral("number")},
                       {QStringLiteral("wind"), {}, QStringLiteral("X,Y,Z")},
                       {QStringLiteral("motion"), {}, QStringLiteral("name")}});
    const std::optional<QStringList> files = parse(parser, kName, arguments, 1);
    if (!files)
        return ExitCode::WrongUsage;
    const QString output = parser.value(QStringLiteral("o"));
    if (!output.endsWith(QLatin1String(".hair"), Qt::CaseInsensitive))
        return wrongUsage(kName, CommandLine::tr("-o takes a name that ends in .hair"));
    const std::optional<double> settle = numberOption(parser, kName, QStringLiteral("settle"), 0.0, 0.0, 60.0);
    const auto hairs = hairsOption(parser, kName);
    const auto wind = windOption(parser, kName);
    const auto motion = motionOption(parser, kName);
    if (!settle || !hairs || !wind || !motion)
        return ExitCode::WrongUsage;

    if (const model::Result<void> free = checkOutput(output, *files); !free)
        return failed(free.error());
    model::Result<model::Project> project = model::loadProject(files->front());
    if (!project)
        return failed(project.error());
    SettledHair hair(std::move(*project), *settle, {.hairs = *hairs, .windVelocity = *wind});
    if (*motion) {
        constexpr double kAfterMotionSeconds = 1.0;
        hair.setMotion(*motion);
        hair.advance(sim::secondsOf(**motion));
        hair.setMotion(std::nullopt);
        hair.advance(kAfterMotionSeconds);
    }
    if (const model::Result<void> written = model::writeHairFile(*hair.frame(), output); !written)
        return failed(written.error());
    return ExitCode::Done;
}

} // namespace hairpaint::app
