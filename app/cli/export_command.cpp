// `hairpaint export`: the hair for other programs.
#include "app/cli/command.h"
#include "app/cli/export_options.h"
#include "app/cli/film.h"
#include "app/cli/interruption.h"
#include "app/cli/option_values.h"
#include "app/cli/terminal.h"
#include "app/cli/verb_options.h"
#include "app/headless/settled_hair.h"
#include "model/disk/staged_files.h"
#include "model/document/document.h"
#include "model/exporting/map_images.h"
#include "model/exporting/uv_sheet.h"
#include "model/files/head_file.h"
#include "model/files/project_file.h"
#include "model/formats/export_format.h"
#include "model/values/sentences.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <array>

namespace hairpaint::app {

namespace {

constexpr const char* kExport = "export";

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

/// What is wanted of the maps; the problem in words.
tl::expected<model::MapImageOptions, QString> readMapOptions(const QCommandLineParser& parser)
{
    model::MapImageOptions options{.grey = parser.isSet(QStringLiteral("grey"))};
    if (parser.isSet(QStringLiteral("image"))) {
        options.format = model::findMapImageFormat(parser.value(QStringLiteral("image")));
        if (options.format == nullptr)
            return tl::unexpected(CommandLine::tr("--image takes %1, not '%2'")
                                      .arg(listOf(model::mapImageSuffixes()), parser.value(QStringLiteral("image"))));
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

/// How the hair comes into the shape that it is exported in.
struct HairMotion
{
    double settleSeconds = 0.0;
    std::optional<glm::vec3> windVelocity;
    std::optional<sim::NeckMotion> motion;
    Film film;
};

/// A film's files are staged beside their targets until the last one is written.
model::Result<void> exportFilm(SettledHair& hair, const HairMotion& wanted, const model::ExportRequest& request,
                               const QString& output)
{
    model::StagedFiles staged(QFileInfo(output).path());
    if (model::Result<void> ready = staged.check(framePath(output, wanted.film.first)); !ready)
        return ready;
    QStringList paths;
    hair.setMotion(wanted.motion);
    for (int number = 0; number <= wanted.film.last; ++number) {
        if (!Interruption::progress()(0.0))
            return model::cancelled(framePath(output, number));
        hair.advance(secondsBefore(number, wanted.film.framesPerSecond));
        if (number < wanted.film.first)
            continue;
        paths += framePath(output, number);
        if (model::Result<void> written =
                model::exportHair(hair.frame(), request, staged.pathFor(paths.back()), Interruption::progress());
            !written)
            return tl::unexpected(staged.named(std::move(written.error()), paths.back()));
    }
    return staged.publish(paths);
}

model::Result<void> exportShape(model::Project project, const HairMotion& wanted, const model::ExportRequest& request,
                                const QString& output)
{
    SettledHair hair(std::move(project), wanted.settleSeconds, {.hairs = {}, .windVelocity = wanted.windVelocity});
    const Interruption interruption;
    if (wanted.film.wanted())
        return exportFilm(hair, wanted, request, output);
    if (wanted.motion) {
        constexpr double kAfterMotionSeconds = 1.0;
        hair.setMotion(wanted.motion);
        hair.advance(sim::secondsOf(*wanted.motion));
        hair.setMotion(std::nullopt);
        hair.advance(kAfterMotionSeconds);
    }
    return model::exportHair(hair.frame(), request, output, Interruption::progress());
}

/// Every file that will be written can be.
model::Result<void> checkShapes(const QString& output, const Film& film, const QStringList& inputs)
{
    if (!film.wanted())
        return checkOutput(output, inputs);
    for (int number = film.first; number <= film.last; ++number)
        if (model::Result<void> free = checkOutput(framePath(output, number), inputs); !free)
            return free;
    return {};
}

/// What would be given for nothing; empty where there is none.
QString uselessOption(const QCommandLineParser& parser)
{
    for (const QString& name : parser.optionNames()) {
        const QLatin1StringView other(optionOf(kExport, name).useWith);
        if (other.isEmpty() || parser.isSet(other))
            continue;
        return (other == QLatin1StringView("o") ? CommandLine::tr("--%1 is for hair; give -o too")
                                                : CommandLine::tr("--%1 is for images of maps; give --maps too"))
            .arg(name);
    }
    return {};
}

} // namespace

ExitCode runExport(const QStringList& arguments)
{
    QCommandLineParser parser;
    const std::optional<QStringList> files = parse(parser, kExport, arguments, 1);
    if (!files)
        return ExitCode::WrongUsage;
    const QString output = parser.value(QStringLiteral("o"));
    const QString mapFolder = parser.value(QStringLiteral("maps"));
    const QString sheet = parser.value(QStringLiteral("uv-sheet"));
    if (output.isEmpty() && mapFolder.isEmpty() && sheet.isEmpty())
        return wrongUsage(kExport, CommandLine::tr("Nothing to export is named: give -o, --maps or --uv-sheet"));
    if (const QString useless = uselessOption(parser); !useless.isEmpty())
        return wrongUsage(kExport, useless);
    tl::expected<model::ExportRequest, QString> request = readRequest(parser, output);
    if (!request)
        return wrongUsage(kExport, request.error());
    tl::expected<model::MapImageOptions, QString> mapOptions = readMapOptions(parser);
    if (!mapOptions)
        return wrongUsage(kExport, mapOptions.error());
    if (!sheet.isEmpty() && !model::isUvSheet(sheet))
        return wrongUsage(kExport, CommandLine::tr("--uv-sheet takes a name that ends in .pdf or .svg"));
    const auto settle = numberOption(parser, kExport, QStringLiteral("settle"));
    const auto hairs = hairsOption(parser, kExport);
    const auto wind = windOption(parser, kExport);
    const auto motion = motionOption(parser, kExport);
    tl::expected<Film, QString> film = framesOption(parser);
    if (!film)
        return wrongUsage(kExport, film.error());
    const auto rate = numberOption(parser, kExport, QStringLiteral("fps"));
    if (!settle || !hairs || !wind || !motion || !rate)
        return ExitCode::WrongUsage;
    film->framesPerSecond = *rate;
    // Points would come and go from frame to frame.
    if (film->wanted() && request->curves.toleranceM > 0.0F)
        return wrongUsage(kExport, CommandLine::tr("--tolerance and --frames exclude each other"));
    const HairMotion wanted{.settleSeconds = *settle, .windVelocity = *wind, .motion = *motion, .film = *film};
    request->curves.hairs = *hairs;

    if (const model::Result<void> free = checkShapes(output, *film, *files); !output.isEmpty() && !free)
        return failed(free.error());
    if (const model::Result<void> free = checkOutput(sheet, *files); !sheet.isEmpty() && !free)
        return failed(free.error());
    model::Result<model::Project> project = model::loadProject(files->front());
    if (!project)
        return failed(project.error());
    model::Result<std::vector<model::CurveGroupName>> groups =
        groupsNamed(*project, parser.values(QStringLiteral("group")), files->front());
    if (!groups)
        return failed(groups.error());
    if (const model::Result<void> whole = model::addProject(*request, *project, files->front(), output); !whole)
        return failed(whole.error());
    if (!sheet.isEmpty())
        if (const model::Result<void> written = model::writeUvSheet(project->head->skin->mesh(), sheet); !written)
            return failed(written.error());
    if (!mapFolder.isEmpty()) {
        if (parser.isSet(QStringLiteral("udim")))
            mapOptions->tiles = model::tilesOf(project->head);
        if (mapOptions->tiles && mapOptions->tiles->isOneMap())
            (void)printLines({CommandLine::tr("%1: its head has one uv tile, so each map is one image, numbered 1001; "
                                              "where an earlier version laid several tiles side by side, import that "
                                              "head anew")
                                  .arg(model::shownPath(files->front()))});
        QDir().mkpath(mapFolder); // Where it can't be made, writing says so.
        const Interruption interruption;
        if (const model::Result<void> written = model::writeMapImages(wantedMapsOf(*project, *groups), mapFolder,
                                                                      *mapOptions, Interruption::progress());
            !written)
            return failed(written.error());
    }
    if (output.isEmpty())
        return ExitCode::Done;
    request->curves.groups = std::move(*groups);
    if (const model::Result<void> written = exportShape(std::move(*project), wanted, *request, output); !written)
        return failed(written.error());
    return ExitCode::Done;
}

} // namespace hairpaint::app
