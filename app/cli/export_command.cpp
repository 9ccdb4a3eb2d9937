// `hairpaint export`: the hair for other programs.
#include "app/cli/command.h"
#include "app/cli/settled_hair.h"
#include "model/document.h"
#include "model/exporting/export_format.h"
#include "model/exporting/map_images.h"
#include "model/exporting/uv_sheet.h"
#include "model/files/project_file.h"
#include "model/files/sentences.h"

namespace hairpaint::app {

namespace {

constexpr const char* kExport = "export";
constexpr double kMetresPerMm = 1e-3;
constexpr double kGreatestToleranceMm = 10.0;

QString formatList()
{
    QStringList suffixes;
    for (const model::ExportFormat& format : model::exportFormats())
        suffixes += QLatin1Char('.') + QLatin1StringView(format.suffix);
    return suffixes.join(QLatin1String(", "));
}

QString targetList()
{
    QStringList ids;
    for (const model::ExportTarget& target : model::exportTargets())
        ids += QString::fromLatin1(target.id);
    return ids.join(QLatin1String(", "));
}

/// Those of these names, all where there are none; the problem where the project has no such group.
model::Result<std::vector<model::CurveGroupName>> groupsNamed(const model::Project& project, const QStringList& names,
                                                              const QString& path)
{
    std::vector<model::CurveGroupName> groups;
    QStringList missing = names;
    for (const model::HairGroup& group : project.groups) {
        if (names.isEmpty() || names.contains(group.name))
            groups.push_back({.id = group.id, .name = group.name});
        missing.removeAll(group.name);
    }
    if (missing.isEmpty())
        return groups;
    return model::failure(
        CommandLine::tr("There is no group '%1' in '%2'; 'hairpaint info' lists those that are there.")
            .arg(missing.front(), model::shownPath(path)));
}

/// What is wanted of the hair, without its groups; the problem in words.
tl::expected<model::ExportRequest, QString> readRequest(const QCommandLineParser& parser, const QString& output)
{
    model::ExportRequest request;
    request.format = &model::exportFormats().front();
    if (parser.isSet(QStringLiteral("o")))
        request.format = model::findExportFormat(output);
    if (request.format == nullptr)
        return tl::unexpected(CommandLine::tr("-o takes a name that ends in %1").arg(formatList()));
    request.target = &model::exportTargets().front();
    if (parser.isSet(QStringLiteral("target"))) {
        const QString id = parser.value(QStringLiteral("target"));
        request.target = model::findExportTarget(id);
        if (request.target == nullptr)
            return tl::unexpected(CommandLine::tr("--target takes %1, not '%2'").arg(targetList(), id));
    }
    return request;
}

/// What is wanted of the maps; the problem in words.
tl::expected<model::MapImageOptions, QString> readMapOptions(const QCommandLineParser& parser)
{
    model::MapImageOptions options{.grey = parser.isSet(QStringLiteral("grey"))};
    if (parser.isSet(QStringLiteral("image"))) {
        options.format = model::findMapImageFormat(parser.value(QStringLiteral("image")));
        if (options.format == nullptr)
            return tl::unexpected(CommandLine::tr("--image takes png, tif, exr or tga, not '%1'")
                                      .arg(parser.value(QStringLiteral("image"))));
    }
    if (parser.isSet(QStringLiteral("depth"))) {
        const QString depth = parser.value(QStringLiteral("depth"));
        if (depth != QLatin1String("8") && depth != QLatin1String("16"))
            return tl::unexpected(CommandLine::tr("--depth takes 8 or 16, not '%1'").arg(depth));
        options.bits = depth.toInt();
    }
    return options;
}

std::vector<model::WantedMap> wantedMapsOf(const model::Project& project,
                                           const std::vector<model::CurveGroupName>& groups)
{
    model::Document document(project);
    std::vector<model::WantedMap> maps;
    maps.reserve(groups.size() * model::mapSpecs().size());
    for (const model::CurveGroupName& group : groups)
        for (const model::MapSpec& spec : model::mapSpecs())
            maps.push_back(
                {.group = group.name, .kind = spec.kind, .resolved = document.resolvedNow(group.id, spec.kind)});
    return maps;
}

std::shared_ptr<const sim::StrandFrame> hairFor(model::Project project, double settle, std::optional<glm::vec3> wind,
                                                std::optional<sim::NeckMotion> motion)
{
    SettledHair hair(std::move(project), settle, {.hairs = {}, .windVelocity = wind});
    if (motion) {
        constexpr double kAfterMotionSeconds = 1.0;
        hair.setMotion(motion);
        hair.advance(sim::secondsOf(*motion));
        hair.setMotion(std::nullopt);
        hair.advance(kAfterMotionSeconds);
    }
    return hair.frame();
}

} // namespace

ExitCode runExport(const QStringList& arguments)
{
    QCommandLineParser parser;
    parser.addOptions({{{QStringLiteral("o"), QStringLiteral("output")}, {}, QStringLiteral("file")},
                       {QStringLiteral("target"), {}, QStringLiteral("name")},
                       {QStringLiteral("group"), {}, QStringLiteral("name")},
                       {QStringLiteral("tolerance"), {}, QStringLiteral("mm")},
                       {QStringLiteral("settle"), {}, QStringLiteral("seconds")},
                       {QStringLiteral("hairs"), {}, QStringLiteral("number")},
                       {QStringLiteral("wind"), {}, QStringLiteral("X,Y,Z")},
                       {QStringLiteral("motion"), {}, QStringLiteral("name")},
                       {QStringLiteral("maps"), {}, QStringLiteral("folder")},
                       {QStringLiteral("image"), {}, QStringLiteral("format")},
                       {QStringLiteral("depth"), {}, QStringLiteral("bits")},
                       {QStringLiteral("grey"), {}},
                       {QStringLiteral("uv-sheet"), {}, QStringLiteral("file")}});
    const std::optional<QStringList> files = parse(parser, kExport, arguments, 1);
    if (!files)
        return ExitCode::WrongUsage;
    const QString output = parser.value(QStringLiteral("o"));
    const QString mapFolder = parser.value(QStringLiteral("maps"));
    const QString sheet = parser.value(QStringLiteral("uv-sheet"));
    if (output.isEmpty() && mapFolder.isEmpty() && sheet.isEmpty())
        return wrongUsage(kExport, CommandLine::tr("Nothing to export is named: give -o, --maps or --uv-sheet"));
    tl::expected<model::ExportRequest, QString> request = readRequest(parser, output);
    if (!request)
        return wrongUsage(kExport, request.error());
    const tl::expected<model::MapImageOptions, QString> mapOptions = readMapOptions(parser);
    if (!mapOptions)
        return wrongUsage(kExport, mapOptions.error());
    if (!sheet.isEmpty() && !model::isUvSheet(sheet))
        return wrongUsage(kExport, CommandLine::tr("--uv-sheet takes a name that ends in .pdf or .svg"));
    const auto settle = numberOption(parser, kExport, QStringLiteral("settle"), 0.0, 0.0, 60.0);
    const auto tolerance = numberOption(parser, kExport, QStringLiteral("tolerance"), 0.0, 0.0, kGreatestToleranceMm);
    const auto hairs = hairsOption(parser, kExport);
    const auto wind = windOption(parser, kExport);
    const auto motion = motionOption(parser, kExport);
    if (!settle || !tolerance || !hairs || !wind || !motion)
        return ExitCode::WrongUsage;
    request->curves.hairs = *hairs;
    request->curves.toleranceM = static_cast<float>(*tolerance * kMetresPerMm);

    for (const QString& file : {output, sheet})
        if (const model::Result<void> free = checkOutput(file, *files); !file.isEmpty() && !free)
            return failed(free.error());
    model::Result<model::Project> project = model::loadProject(files->front());
    if (!project)
        return failed(project.error());
    model::Result<std::vector<model::CurveGroupName>> groups =
        groupsNamed(*project, parser.values(QStringLiteral("group")), files->front());
    if (!groups)
        return failed(groups.error());
    if (!sheet.isEmpty())
        if (const model::Result<void> written = model::writeUvSheet(project->head->skin->mesh(), sheet); !written)
            return failed(written.error());
    if (!mapFolder.isEmpty())
        if (const model::Result<void> written =
                model::writeMapImages(wantedMapsOf(*project, *groups), mapFolder, *mapOptions);
            !written)
            return failed(written.error());
    if (output.isEmpty())
        return ExitCode::Done;
    request->curves.groups = std::move(*groups);
    const auto hair = hairFor(std::move(*project), *settle, *wind, *motion);
    if (const model::Result<void> written = model::exportHair(hair, *request, output); !written)
        return failed(written.error());
    return ExitCode::Done;
}

} // namespace hairpaint::app
