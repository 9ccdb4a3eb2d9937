// `hairpaint new`: a project from a head, a preset and images.
#include "app/background/heads.h"
#include "app/cli/command.h"
#include "app/cli/option_values.h"
#include "app/cli/space_options.h"
#include "app/cli/terminal.h"
#include "app/styles/library.h"
#include "model/document/scene_commands.h"
#include "model/files/map_names.h"
#include "model/files/map_source.h"
#include "model/files/project_file.h"
#include "model/files/tile_names.h"
#include "model/importing/curve_import.h"
#include "model/project/content_budget.h"
#include "model/styles/group_adoption.h"
#include "model/styles/style_use.h"
#include "model/values/names.h"
#include "model/values/sentences.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace hairpaint::app {

namespace {

const QString kCurves = QStringLiteral("curves");

/// `[GROUP/]KIND[:grey]=IMAGE`
struct MapArgument
{
    QString group;
    const model::MapSpec* spec = nullptr;
    bool grey = false;
    QString image;
};

std::optional<MapArgument> parseMapArgument(const QString& argument)
{
    const qsizetype equals = argument.indexOf(QLatin1Char('='));
    if (equals <= 0 || equals + 1 == argument.size())
        return std::nullopt;
    MapArgument result;
    QString kind = argument.left(equals);
    result.image = argument.mid(equals + 1);
    if (const qsizetype slash = kind.lastIndexOf(QLatin1Char('/')); slash >= 0) {
        if (slash == 0)
            return std::nullopt; // A group without a name would be taken for none at all.
        result.group = kind.left(slash);
        kind = kind.mid(slash + 1);
    }
    if (kind.endsWith(QLatin1String(":grey"))) {
        result.grey = true;
        kind.chop(5);
    }
    result.spec = model::findMapSpec(kind);
    if (result.spec == nullptr)
        return std::nullopt;
    return result;
}

model::HairGroup* findGroup(model::Project& project, const QString& name)
{
    if (name.isEmpty())
        return project.groups.empty() ? nullptr : project.groups.data();
    const auto found = std::ranges::find_if(project.groups, [&name](const model::HairGroup& group) {
        return group.name == name || model::shownName(group.name) == name;
    });
    return found == project.groups.end() ? nullptr : &*found;
}

/// Those of --maps that name a map.
model::Result<std::vector<MapArgument>> mapsOfFolder(const model::Project& project, const QString& folder)
{
    QStringList patterns;
    for (const QString& ending : model::imageEndings())
        patterns += QStringLiteral("*.") + ending;
    std::vector<MapArgument> maps;
    QStringList paths;
    for (const QFileInfo& file : QDir(folder).entryInfoList(patterns, QDir::Files, QDir::Name))
        paths.append(file.filePath());
    for (const QString& path : model::tilePatternsOf(paths, model::tilesOf(project.head)))
        if (const std::optional<model::NamedMap> named = model::mapNamedBy(path, project.groups))
            maps.push_back({.group = named->group ? project.groups[*named->group].name : QString(),
                            .spec = &model::mapSpec(named->kind),
                            .image = path});
    if (maps.empty())
        return model::failure(CommandLine::tr("'%1' holds no image that is named after a map, as head_density.png is; "
                                              "rename them or choose another folder.")
                                  .arg(model::shownPath(folder)));
    return maps;
}

model::Result<void> importMap(model::Project& project, model::ImporterClient& client, const MapArgument& argument)
{
    model::HairGroup* group = findGroup(project, argument.group);
    if (group == nullptr)
        return model::failure(
            CommandLine::tr("'%1' goes to the hair group '%2', and the project has none of that name; "
                            "name one that it has.")
                .arg(argument.image, argument.group));
    const model::UvTiles tiles = model::tilesOf(project.head);
    const QString path = model::tilePatternOf(argument.image, tiles);
    std::vector<int> leftOut;
    model::Result<model::ImageLayer> image = model::layerFromPath(
        client, path, *argument.spec, argument.grey ? std::optional(true) : std::nullopt, tiles, &leftOut);
    if (!image)
        return tl::unexpected(image.error());
    if (!leftOut.empty())
        (void)printLines({QStringLiteral("%1: %2").arg(model::shownPath(path), model::leftOutTiles(leftOut))});
    model::MapStack& stack = group->map(argument.spec->kind);
    stack.size = image->raster.size();
    stack.layers.clear();
    model::Layer layer =
        model::makeLayer(project, *argument.spec, stack.size, model::mapTitleOf(path).section(QLatin1Char('.'), 0, 0));
    layer.raster = std::move(image->raster);
    stack.layers.push_back(std::move(layer));
    return {};
}

/// Adds a file's groups to the project.
model::Result<void> importCurves(model::Project& project, const QString& path, const model::CurveSpaceChoice& choice)
{
    model::CurveRemarks remarks;
    model::Result<std::vector<model::HairGroup>> groups =
        model::groupsFromCurves(path, choice, project.head, {}, &remarks);
    if (!groups)
        return tl::unexpected(groups.error());
    if (remarks.leftOut > 0)
        (void)printLines(
            {CommandLine::tr("%1: %Ln strands left out, which are broken", nullptr, static_cast<int>(remarks.leftOut))
                 .arg(model::shownPath(path))});
    if (!remarks.unread.isEmpty())
        (void)printLines({QStringLiteral("%1: %2").arg(model::shownPath(path), model::unreadFiles(remarks.unread))});
    for (model::HairGroup& group : *groups)
        model::adoptGroup(project, std::move(group));
    return {};
}

} // namespace

ExitCode runNew(const QStringList& arguments)
{
    constexpr const char* kName = "new";
    const QString kMaxCandidates = QStringLiteral("max-candidates");
    QCommandLineParser parser;
    if (!parse(parser, kName, arguments, 0))
        return ExitCode::WrongUsage;
    const QString output = parser.value(QStringLiteral("o"));
    if (output.isEmpty())
        return wrongUsage(kName, CommandLine::tr("-o and the project's name are needed"));
    if (!isProjectName(output))
        return wrongUsage(kName, CommandLine::tr("-o takes a name that ends in .hairpaint"));

    std::vector<MapArgument> maps;
    for (const QString& argument : parser.values(QStringLiteral("map"))) {
        const std::optional<MapArgument> map = parseMapArgument(argument);
        if (!map)
            return wrongUsage(kName, CommandLine::tr("--map %1 names no map").arg(argument));
        maps.push_back(*map);
    }
    const std::optional<model::CurveSpaceChoice> curveSpace = curveSpaceOptions(parser, kName);
    if (!curveSpace)
        return ExitCode::WrongUsage;
    const std::optional<model::HeadChoice> headSpace = headSpaceOptions(parser, kName);
    if (!headSpace)
        return ExitCode::WrongUsage;
    model::Project project = model::newProject();
    const std::optional<std::int64_t> maxCandidates =
        countOption(parser, kName, kMaxCandidates, project.maxHairs, model::kMostHairs);
    if (!maxCandidates)
        return ExitCode::WrongUsage;
    project.maxHairs = static_cast<int>(*maxCandidates);
    if (parser.isSet(QStringLiteral("seed"))) {
        bool isNumber = false;
        project.seed = parser.value(QStringLiteral("seed")).toULongLong(&isNumber);
        // Larger numbers would not survive the file's JSON.
        if (!isNumber || project.seed > (1ULL << 53U))
            return wrongUsage(kName, CommandLine::tr("--seed takes a whole number up to 2^53"));
    }

    QStringList inputs{parser.value(QStringLiteral("head")), parser.value(QStringLiteral("preset"))};
    inputs += parser.values(kCurves);
    for (const MapArgument& map : maps)
        inputs.append(map.image);
    if (const model::Result<void> free = checkOutput(output, inputs); !free)
        return failed(free.error());
    if (const QString mesh = parser.value(QStringLiteral("head")); !mesh.isEmpty()) {
        model::Result<ImportedHead> head = importHead(mesh, *headSpace);
        if (!head)
            return failed(head.error());
        QStringList lines;
        for (const QString& remark : head->remarks)
            lines.append(QStringLiteral("%1: %2").arg(model::shownPath(mesh), remark));
        if (!lines.isEmpty())
            (void)printLines(lines);
        model::putHead(project, head->head);
        project.setShapesOfHead(head->ellipsoids);
    }
    if (const QString name = parser.value(QStringLiteral("preset")); !name.isEmpty()) {
        const model::Result<model::Preset> preset = loadPresetNamed(name);
        if (!preset)
            return failed(preset.error());
        model::applyPreset(project, *preset);
    }
    if (parser.isSet(kCurves) && !parser.isSet(QStringLiteral("preset")))
        project.groups.clear(); // The hair is that of the files.
    for (const QString& path : parser.values(kCurves))
        if (const model::Result<void> imported = importCurves(project, path, *curveSpace); !imported)
            return failed(imported.error());
    if (const QString folder = parser.value(QStringLiteral("maps")); !folder.isEmpty()) {
        model::Result<std::vector<MapArgument>> found = mapsOfFolder(project, folder);
        if (!found)
            return failed(found.error());
        maps.insert(maps.begin(), found->begin(), found->end()); // Those named one by one count more.
    }
    model::ImporterClient client;
    for (const MapArgument& map : maps) {
        if (const model::Result<void> imported = importMap(project, client, map); !imported)
            return failed(imported.error());
        // Before the next is read, and long before they are encoded.
        if (model::excessOf(project.groups) != model::ContentExcess::None)
            return failed({CommandLine::tr("With '%1' the maps would be larger than a project can be; use smaller "
                                           "images, or fewer.")
                               .arg(model::shownPath(map.image))});
    }
    if (const model::Result<void> saved = model::saveProject(project, output, {}); !saved)
        return failed(saved.error());
    return ExitCode::Done;
}

} // namespace hairpaint::app
