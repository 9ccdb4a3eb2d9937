// `hairpaint export`: the hair for other programs.
#include "app/cli/command.h"
#include "app/cli/film.h"
#include "app/cli/interruption.h"
#include "app/headless/settled_hair.h"
#include "model/disk/staged_files.h"
#include "model/document/document.h"
#include "model/exporting/export_format.h"
#include "model/exporting/map_images.h"
#include "model/exporting/uv_sheet.h"
#include "model/files/project_file.h"
#include "model/project/skin_tone.h"
#include "model/values/sentences.h"

#include <QFileInfo>

#include <algorithm>
#include <array>

namespace hairpaint::app {

namespace {

constexpr const char* kExport = "export";
constexpr double kMetresPerMm = 1e-3;
constexpr double kGreatestToleranceMm = 10.0;

QString formatList()
{
    return QLatin1Char('.') + model::exportSuffixes().join(QLatin1String(", ."));
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

/// --cards and what belongs to it; the problem in words.
std::optional<QString> readCards(const QCommandLineParser& parser, const QString& output, model::ExportRequest& request)
{
    const QString triangles = parser.value(QStringLiteral("triangles"));
    const QString atlas = parser.value(QStringLiteral("atlas"));
    const QString levels = parser.value(QStringLiteral("lods"));
    const bool isAvatar = request.format->isAvatar; // Of cards, with bones and head.
    if (parser.isSet(QStringLiteral("author")) && !isAvatar)
        return CommandLine::tr("--author is for avatars; with it -o takes a name that ends in .vrm");
    if (!parser.isSet(QStringLiteral("cards")) && !isAvatar) {
        constexpr std::array kOfCards = {"triangles", "atlas", "lods", "bones", "with-head"};
        const auto* const given =
            std::ranges::find_if(kOfCards, [&](const char* name) { return parser.isSet(QString::fromLatin1(name)); });
        if (given == kOfCards.end())
            return std::nullopt;
        return CommandLine::tr("--%1 is for cards; give --cards too").arg(QLatin1StringView(*given));
    }
    request.format = model::findExportFormat(output, &model::cardFormat());
    if (!request.format->hasCards)
        return CommandLine::tr("Cards are written as glTF; with --cards -o takes a name that ends in .glb");
    if (parser.isSet(QStringLiteral("frames")))
        return isAvatar ? CommandLine::tr("An avatar stands still; --frames is for other formats than .vrm")
                        : CommandLine::tr("--cards and --frames exclude each other");
    if (isAvatar && parser.isSet(QStringLiteral("lods")))
        return CommandLine::tr("Avatars have one level of detail; --lods is for cards as .glb");
    request.cards.springBones = parser.isSet(QStringLiteral("bones"));
    request.cards.withHead = parser.isSet(QStringLiteral("with-head"));
    using Cards = model::CardSettings;
    if (!levels.isEmpty()) {
        bool isNumber = false;
        request.cards.levels = levels.toInt(&isNumber);
        if (!isNumber || request.cards.levels < 1 || request.cards.levels > Cards::kMostLevels)
            return CommandLine::tr("--lods takes a number from 1 to %1, not '%2'").arg(Cards::kMostLevels).arg(levels);
    }
    if (!triangles.isEmpty()) {
        bool isNumber = false;
        request.cards.triangles = triangles.toInt(&isNumber);
        if (!isNumber || request.cards.triangles < Cards::kFewestTriangles ||
            request.cards.triangles > Cards::kMostTriangles)
            return CommandLine::tr("--triangles takes a number from %1 to %2, not '%3'")
                .arg(Cards::kFewestTriangles)
                .arg(Cards::kMostTriangles)
                .arg(triangles);
    }
    if (!atlas.isEmpty()) {
        QStringList sizes;
        for (int size = Cards::kSmallestAtlasPx; size <= Cards::kLargestAtlasPx; size *= 2)
            sizes += QString::number(size);
        if (!sizes.contains(atlas))
            return CommandLine::tr("--atlas takes %1, not '%2'").arg(sizes.join(QLatin1String(", ")), atlas);
        request.cards.atlasPx = atlas.toInt();
    }
    return std::nullopt;
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
    if (const auto problem = readCards(parser, output, request); problem)
        return tl::unexpected(*problem);
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

/// How the hair comes into the shape that it is exported in.
struct HairMotion
{
    double settleSeconds = 0.0;
    std::optional<glm::vec3> windVelocity;
    std::optional<sim::NeckMotion> motion;
    Film film;
};

/// A film's files lie beside their places until the last one is there.
model::Result<void> exportFilm(SettledHair& hair, const HairMotion& wanted, const model::ExportRequest& request,
                               const QString& output)
{
    model::StagedFiles staged(QFileInfo(output).path());
    if (model::Result<void> ready = staged.check(framePath(output, wanted.film.first)); !ready)
        return ready;
    QStringList places;
    hair.setMotion(wanted.motion);
    for (int number = 0; number <= wanted.film.last; ++number) {
        if (!Interruption::progress()(0.0))
            return model::cancelled(framePath(output, number));
        hair.advance(secondsBefore(number, wanted.film.framesPerSecond));
        if (number < wanted.film.first)
            continue;
        places += framePath(output, number);
        if (model::Result<void> written =
                model::exportHair(hair.frame(), request, staged.pathFor(places.back()), Interruption::progress());
            !written)
            return tl::unexpected(staged.named(std::move(written.error()), places.back()));
    }
    return staged.publish(places);
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
    constexpr std::array kOfHair = {"target", "tolerance", "settle", "hairs", "wind", "motion", "frames", "fps"};
    constexpr std::array kOfMaps = {"image", "depth", "grey"};
    const auto isGiven = [&parser](const char* name) { return parser.isSet(QString::fromLatin1(name)); };
    if (const auto* const name = std::ranges::find_if(kOfHair, isGiven); !isGiven("o") && name != kOfHair.end())
        return CommandLine::tr("--%1 is for hair; give -o too").arg(QLatin1StringView(*name));
    if (const auto* const name = std::ranges::find_if(kOfMaps, isGiven); !isGiven("maps") && name != kOfMaps.end())
        return CommandLine::tr("--%1 is for images of maps; give --maps too").arg(QLatin1StringView(*name));
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
    tl::expected<Film, QString> film = framesOption(parser);
    if (!film)
        return wrongUsage(kExport, film.error());
    const auto rate = numberOption(parser, kExport, QStringLiteral("fps"), film->framesPerSecond, 1.0, 240.0);
    if (!settle || !tolerance || !hairs || !wind || !motion || !rate)
        return ExitCode::WrongUsage;
    film->framesPerSecond = *rate;
    // Points would come and go from frame to frame.
    if (film->wanted() && *tolerance > 0.0)
        return wrongUsage(kExport, CommandLine::tr("--tolerance and --frames exclude each other"));
    const HairMotion wanted{.settleSeconds = *settle, .windVelocity = *wind, .motion = *motion, .film = *film};
    request->curves.hairs = *hairs;
    request->curves.toleranceM = static_cast<float>(*tolerance * kMetresPerMm);

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
    if (request->format->isAvatar) {
        const model::Checked<std::shared_ptr<const model::Avatar>> avatar = model::avatarOf(
            *project->head, QFileInfo(files->front()).completeBaseName(), parser.value(QStringLiteral("author")));
        if (!avatar)
            return failed(model::cannotWrite(output, avatar.error()).value());
        request->avatar = *avatar;
    }
    if (!sheet.isEmpty())
        if (const model::Result<void> written = model::writeUvSheet(project->head->skin->mesh(), sheet); !written)
            return failed(written.error());
    if (!mapFolder.isEmpty()) {
        const Interruption interruption;
        if (const model::Result<void> written = model::writeMapImages(wantedMapsOf(*project, *groups), mapFolder,
                                                                      *mapOptions, Interruption::progress());
            !written)
            return failed(written.error());
    }
    if (output.isEmpty())
        return ExitCode::Done;
    request->curves.groups = std::move(*groups);
    request->worn = project->worn;
    request->skinColour = model::skinLook(project->skin).skin;
    if (const model::Result<void> written = exportShape(std::move(*project), wanted, *request, output); !written)
        return failed(written.error());
    return ExitCode::Done;
}

} // namespace hairpaint::app
