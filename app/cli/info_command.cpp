// `hairpaint info` and `hairpaint presets`: what is in a project, and in the library.
#include "app/cli/command.h"
#include "app/styles/library.h"
#include "model/document/document.h"
#include "model/files/project_file.h"
#include "model/files/project_json.h"
#include "model/values/names.h"
#include "sim/groom/groom.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocale>

namespace hairpaint::app {

namespace {

QJsonArray mapsOf(const model::HairGroup& group)
{
    QJsonArray maps;
    for (const model::MapStack& stack : group.maps)
        maps.append(QJsonObject{{QStringLiteral("kind"), QLatin1StringView(model::mapSpec(stack.kind).id)},
                                {QStringLiteral("width"), stack.size},
                                {QStringLiteral("height"), stack.size},
                                {QStringLiteral("layers"), static_cast<int>(stack.layers.size())}});
    return maps;
}

/// What keeps hairs from growing that are painted; null where nothing does.
QJsonValue idOf(sim::HairLimit limit)
{
    switch (limit) {
    case sim::HairLimit::None:
        break;
    case sim::HairLimit::MaxHairs:
        return QStringLiteral("max_candidates");
    case sim::HairLimit::Memory:
        return QStringLiteral("memory");
    }
    return QJsonValue::Null;
}

QJsonObject describe(const model::Project& project, const std::vector<std::shared_ptr<const sim::Groom>>& grooms)
{
    qint64 hairs = 0;
    qint64 exported = 0;
    qint64 basisHairs = 0;
    QJsonArray groups;
    for (std::size_t i = 0; i < project.groups.size(); ++i) {
        const model::HairGroup& group = project.groups[i];
        const sim::Groom& groom = *grooms[i];
        hairs += static_cast<qint64>(groom.hairCount);
        exported += static_cast<qint64>(groom.drawnCount);
        basisHairs += static_cast<qint64>(groom.basisCount);
        groups.append(QJsonObject{{QStringLiteral("name"), group.name},
                                  {QStringLiteral("hairs"), static_cast<qint64>(groom.hairCount)},
                                  {QStringLiteral("limited_by"), idOf(groom.limit)},
                                  {QStringLiteral("nodes_per_hair"), group.settings.nodesPerHair},
                                  {QStringLiteral("maps"), mapsOf(group)}});
    }
    const sim::HeadMesh& mesh = project.head->skin->mesh();
    return {{QStringLiteral("format_version"), model::formatVersionOf(project)},
            {QStringLiteral("seed"), static_cast<qint64>(project.seed)},
            {QStringLiteral("max_candidates"), project.maxHairs},
            {QStringLiteral("max_hairs"), project.maxHairs}, // Its name in 0.1.
            {QStringLiteral("head"),
             QJsonObject{{QStringLiteral("name"), project.head->name},
                         {QStringLiteral("vertices"), static_cast<qint64>(mesh.positionsHd.size())},
                         {QStringLiteral("triangles"), static_cast<qint64>(mesh.triangles.size())}}},
            {QStringLiteral("hairs"), hairs},
            {QStringLiteral("exported"), exported},
            {QStringLiteral("basis_hairs"), basisHairs},
            {QStringLiteral("groups"), groups}};
}

/// Qt's JSON has signed numbers of 64 bits only, and a seed has no sign.
QByteArray asJson(const QJsonObject& info, std::uint64_t seed)
{
    const QByteArray key = "\"seed\": ";
    QByteArray text = QJsonDocument(info).toJson();
    text.replace(key + QByteArray::number(static_cast<qint64>(seed)), key + QByteArray::number(quint64{seed}));
    return text;
}

/// A number as people read it.
QString count(const QJsonObject& object, const char* key)
{
    return QLocale().toString(object[QLatin1StringView(key)].toInteger());
}

QStringList asText(const QJsonObject& info, std::uint64_t seed)
{
    // Names may hold "%2" themselves, so each text takes all its parts at once.
    const QJsonObject head = info[QLatin1StringView("head")].toObject();
    QStringList lines{
        CommandLine::tr("Head: %1, %2 vertices, %3 triangles")
            .arg(head[QLatin1StringView("name")].toString(), count(head, "vertices"), count(head, "triangles"))};
    lines += CommandLine::tr("Hairs: %1 (%2 exported, %3 simulated), seed %4")
                 .arg(count(info, "hairs"), count(info, "exported"), count(info, "basis_hairs"), QString::number(seed));
    for (const auto& value : info[QLatin1StringView("groups")].toArray()) {
        const QJsonObject group = value.toObject();
        lines += CommandLine::tr("Group %1: %2 hairs of %3 nodes")
                     .arg(model::shownName(group[QLatin1StringView("name")].toString()), count(group, "hairs"),
                          count(group, "nodes_per_hair"));
        const QString limit = group[QLatin1StringView("limited_by")].toString();
        if (limit == QLatin1String("max_candidates"))
            lines +=
                CommandLine::tr("  Fewer hairs than painted: the limit of %1 candidates for the whole head is reached")
                    .arg(count(info, "max_candidates"));
        else if (limit == QLatin1String("memory"))
            lines += CommandLine::tr("  Fewer hairs than painted: memory would not hold more");
        for (const auto& mapValue : group[QLatin1StringView("maps")].toArray()) {
            const QJsonObject map = mapValue.toObject();
            const model::MapSpec* spec = model::findMapSpec(map[QLatin1StringView("kind")].toString());
            lines += CommandLine::tr("  %1: %2 x %3, layers: %4")
                         .arg(spec->titleText(), count(map, "width"), count(map, "height"), count(map, "layers"));
        }
    }
    return lines;
}

} // namespace

ExitCode runInfo(const QStringList& arguments)
{
    QCommandLineParser parser;
    const std::optional<QStringList> files = parse(parser, "info", arguments, 1);
    if (!files)
        return ExitCode::WrongUsage;
    model::Result<model::Project> project = model::loadProject(files->front());
    if (!project)
        return failed(project.error());
    const model::Document document(std::move(*project));
    sim::GroomBuilder builder;
    const sim::GroomBuilder::Report report = builder.update(document.groomInput());
    const QJsonObject info = describe(document.project(), report.grooms);
    const std::uint64_t seed = document.project().seed;
    return parser.isSet(QStringLiteral("json")) ? printJson(asJson(info, seed)) : printOut(asText(info, seed));
}

ExitCode runPresets(const QStringList& arguments)
{
    QCommandLineParser parser;
    if (!parse(parser, "presets", arguments, 0))
        return ExitCode::WrongUsage;
    QJsonArray list;
    QList<QStringList> rows;
    for (const model::PresetEntry& entry : model::listPresets(ownPresetFolder())) {
        list.append(QJsonObject{{QStringLiteral("name"), entry.name},
                                {QStringLiteral("tags"), QJsonArray::fromStringList(entry.tags)},
                                {QStringLiteral("folder"), entry.folder}});
        QStringList tags;
        for (const QString& tag : entry.tags)
            tags.append(model::shownName(tag));
        rows.append(
            QStringList{model::shownName(entry.name), model::shownName(entry.folder), tags.join(QStringLiteral(", "))});
    }
    return parser.isSet(QStringLiteral("json")) ? printJson(QJsonDocument(list).toJson()) : printOut(rows);
}

} // namespace hairpaint::app
