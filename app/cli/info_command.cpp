// `hairpaint info` and `hairpaint presets`: what is in a project, and in the library.
#include "app/cli/command.h"
#include "app/library.h"
#include "model/document.h"
#include "model/files/migrations.h"
#include "model/files/project_file.h"
#include "model/names.h"
#include "sim/groom.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

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
                                  {QStringLiteral("nodes_per_hair"), group.settings.nodesPerHair},
                                  {QStringLiteral("maps"), mapsOf(group)}});
    }
    const sim::HeadMesh& mesh = project.head->skin->mesh();
    return {{QStringLiteral("format_version"), model::kFormatVersion},
            {QStringLiteral("seed"), static_cast<qint64>(project.seed)},
            {QStringLiteral("head"),
             QJsonObject{{QStringLiteral("name"), project.head->name},
                         {QStringLiteral("vertices"), static_cast<qint64>(mesh.positionsHd.size())},
                         {QStringLiteral("triangles"), static_cast<qint64>(mesh.triangles.size())}}},
            {QStringLiteral("hairs"), hairs},
            {QStringLiteral("exported"), exported},
            {QStringLiteral("basis_hairs"), basisHairs},
            {QStringLiteral("groups"), groups}};
}

QString asText(const QJsonObject& info)
{
    const QJsonObject head = info[QLatin1StringView("head")].toObject();
    QString text = CommandLine::tr("Head: %1, %L2 vertices, %L3 triangles\n")
                       .arg(head[QLatin1StringView("name")].toString())
                       .arg(head[QLatin1StringView("vertices")].toInteger())
                       .arg(head[QLatin1StringView("triangles")].toInteger());
    text += CommandLine::tr("Hairs: %L1 (%L2 exported, %L3 basis hairs), seed %4\n")
                .arg(info[QLatin1StringView("hairs")].toInteger())
                .arg(info[QLatin1StringView("exported")].toInteger())
                .arg(info[QLatin1StringView("basis_hairs")].toInteger())
                .arg(info[QLatin1StringView("seed")].toInteger());
    for (const auto& value : info[QLatin1StringView("groups")].toArray()) {
        const QJsonObject group = value.toObject();
        text += CommandLine::tr("Group %1: %L2 hairs of %3 nodes\n")
                    .arg(group[QLatin1StringView("name")].toString())
                    .arg(group[QLatin1StringView("hairs")].toInteger())
                    .arg(group[QLatin1StringView("nodes_per_hair")].toInt());
        for (const auto& mapValue : group[QLatin1StringView("maps")].toArray()) {
            const QJsonObject map = mapValue.toObject();
            text += CommandLine::tr("  %1: %2 x %3, layers: %4\n")
                        .arg(map[QLatin1StringView("kind")].toString())
                        .arg(map[QLatin1StringView("width")].toInt())
                        .arg(map[QLatin1StringView("height")].toInt())
                        .arg(map[QLatin1StringView("layers")].toInt());
        }
    }
    return text;
}

} // namespace

ExitCode runInfo(const QStringList& arguments)
{
    QCommandLineParser parser;
    parser.addOption(QCommandLineOption(QStringLiteral("json")));
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
    printOut(parser.isSet(QStringLiteral("json")) ? QString::fromUtf8(QJsonDocument(info).toJson()) : asText(info));
    return ExitCode::Done;
}

ExitCode runPresets(const QStringList& arguments)
{
    QCommandLineParser parser;
    parser.addOption(QCommandLineOption(QStringLiteral("json")));
    if (!parse(parser, "presets", arguments, 0))
        return ExitCode::WrongUsage;
    QJsonArray list;
    QString text;
    for (const model::PresetEntry& entry : model::listPresets(ownPresetFolder())) {
        list.append(QJsonObject{{QStringLiteral("name"), entry.name},
                                {QStringLiteral("tags"), QJsonArray::fromStringList(entry.tags)},
                                {QStringLiteral("folder"), entry.folder}});
        QStringList tags;
        for (const QString& tag : entry.tags)
            tags.append(model::shownName(tag));
        text += QStringLiteral("%1\t%2\t%3\n")
                    .arg(model::shownName(entry.name), model::shownName(entry.folder), tags.join(QStringLiteral(", ")));
    }
    printOut(parser.isSet(QStringLiteral("json")) ? QString::fromUtf8(QJsonDocument(list).toJson()) : text);
    return ExitCode::Done;
}

} // namespace hairpaint::app
