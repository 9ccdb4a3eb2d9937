// Dialogs, and the work behind them.
#include "app/exchange/map_exchange.h"

#include "model/document/commands.h"
#include "model/exporting/uv_sheet.h"
#include "model/files/image_map.h"
#include "model/files/importer_client.h"
#include "model/values/names.h"

#include <QDir>
#include <QFileInfo>
#include <QMessageBox>

#include <algorithm>

namespace hairpaint::app {

namespace {

/// Null where there is no such group any more.
const model::MapStack* mapOf(const model::Document& document, const model::LayerAddress& address)
{
    const model::HairGroup* group = document.committed().group(address.group);
    return group != nullptr ? &group->map(address.map) : nullptr;
}

} // namespace

MapExchange::MapExchange(Session& session, FileWork& files)
    : QObject(&files), m_session(session), m_files(files), m_outside(session, files)
{}

QString MapExchange::noGroupText()
{
    return tr("There is no hair group whose map it could be; add one in the panel Hair.");
}

void MapExchange::importImage(bool grey)
{
    const QString path =
        m_files.askOpenPath(tr("Load image into %1").arg(model::mapSpec(m_session.editor().target().map()).titleText()),
                            tr("Images (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.tga *.bmp *.webp *.psd)"));
    if (!path.isEmpty())
        importImageFrom(path, grey);
}

void MapExchange::importImageFrom(const QString& path, bool grey)
{
    model::Document& document = m_session.document();
    m_session.endPreviews(); // What is only shown is no target.
    const model::LayerAddress target = m_session.editor().target().address();
    const model::MapStack* map = mapOf(document, target);
    if (map == nullptr)
        return m_files.complain(noGroupText());
    const model::MapSpec& spec = model::mapSpec(target.map);
    const QString name = QFileInfo(path).fileName();
    std::optional<model::ImageLayer> image =
        m_files.read<model::ImageLayer>(path, [path, &spec, grey, size = map->size](const model::Progress& progress) {
            return model::layerFromFile(path, spec, grey, size, progress);
        });
    if (!image)
        return;
    map = mapOf(document, target); // Much may have happened meanwhile.
    if (map == nullptr || map->size != image->raster.size())
        return;
    const QSize mapSize(map->size, map->size);
    const int top = static_cast<int>(map->layers.size());
    document.push(model::insertLayerCommand(
        document, target.group, target.map,
        {.id = 0, .name = QFileInfo(path).completeBaseName(), .raster = std::move(image->raster)}, top,
        tr("Load %1 into %2").arg(name, spec.titleText())));
    if (image->imageSize != mapSize)
        m_files.tell(tr("%1 was resampled from %2 × %3 to %4 × %4; Map > Map size changes the map's")
                         .arg(name)
                         .arg(image->imageSize.width())
                         .arg(image->imageSize.height())
                         .arg(mapSize.width()));
}

void MapExchange::exportMap()
{
    const view::EditorState& editor = m_session.editor();
    const model::MapSpec& spec = model::mapSpec(editor.target().map());
    const QString path = m_files.askSavePath({.title = tr("Save %1 as image").arg(spec.titleText()),
                                              .suggestedPath = QLatin1StringView(spec.id),
                                              .filter = tr("Images (*.png *.tif *.exr *.tga)"),
                                              .suffix = QStringLiteral("png"),
                                              .otherSuffixes = {QStringLiteral("tiff")}});
    if (path.isEmpty())
        return;
    m_session.endPreviews(); // What is only shown is no part of the map.
    const auto resolved = m_session.document().resolvedNow(editor.target().group(), editor.target().map());
    if (resolved == nullptr)
        return m_files.complain(noGroupText());
    m_files.write(path, [resolved, &spec, path](const model::Progress& progress) {
        return model::ImporterClient().writeImage(model::imageFromMap(*resolved, spec), path, 16, progress);
    });
}

std::vector<model::WantedMap> MapExchange::wantedMaps(view::MapRange range)
{
    model::Document& document = m_session.document();
    const view::EditorState& editor = m_session.editor();
    std::vector<model::WantedMap> maps;
    maps.reserve(document.committed().groups.size() * model::mapSpecs().size());
    for (const model::HairGroup& group : document.committed().groups)
        for (const model::MapSpec& spec : model::mapSpecs()) {
            const bool isGroup = range == view::MapRange::All || group.id == editor.target().group();
            if (isGroup && (range != view::MapRange::Active || spec.kind == editor.target().map()))
                maps.push_back(
                    {.group = group.name, .kind = spec.kind, .resolved = document.resolvedNow(group.id, spec.kind)});
        }
    return maps;
}

void MapExchange::saveMaps()
{
    m_session.endPreviews(); // What is only shown is no part of a map.
    const view::EditorState& editor = m_session.editor();
    const model::HairGroup* group = m_session.document().committed().group(editor.target().group());
    if (group == nullptr)
        return m_files.complain(tr("There is no hair group whose maps they could be; add one in the panel Hair."));
    view::ExportMapsDialog dialog(model::mapSpec(editor.target().map()).titleText(), model::shownName(group->name),
                                  m_choice, &m_files.window());
    m_files.announce(dialog, view::HelpDialog::Topic::MapExport);
    if (dialog.exec() != QDialog::Accepted)
        return;
    m_choice = dialog.choice();
    const QString folder = m_files.askFolder(dialog.windowTitle());
    if (folder.isEmpty())
        return;
    const std::vector<model::WantedMap> maps = wantedMaps(m_choice.range);
    QStringList there = model::mapImageNames(maps, *m_choice.options.format);
    const int count = static_cast<int>(there.size());
    there.removeIf([&folder](const QString& name) { return !QFileInfo::exists(QDir(folder).filePath(name)); });
    if (!there.isEmpty() &&
        QMessageBox::warning(&m_files.window(), dialog.windowTitle(),
                             tr("There are already %Ln of these files, '%1' among them. Replace them?", nullptr,
                                static_cast<int>(there.size()))
                                 .arg(there.front()),
                             QMessageBox::Yes | QMessageBox::No, QMessageBox::No) != QMessageBox::Yes)
        return;
    const bool written =
        m_files.change({.text = tr("Writing maps"), .whenCancelled = tr("The maps were not written: cancelled")},
                       folder, [maps, folder, options = m_choice.options](const model::Progress& progress) {
                           return model::writeMapImages(maps, folder, options, progress);
                       });
    if (written)
        m_files.tell(tr("%Ln maps written", nullptr, count));
}

void MapExchange::saveSheet()
{
    const std::shared_ptr<const model::Head> head = m_session.document().committed().head;
    const QString path = m_files.askSavePath({.title = tr("Save UV sheet"),
                                              .suggestedPath = tr("uv-sheet"),
                                              .filter = tr("PDF documents (*.pdf);;SVG drawings (*.svg)"),
                                              .suffix = QStringLiteral("pdf")});
    if (path.isEmpty())
        return;
    m_files.write(path, [head, path](const model::Progress& progress) {
        return model::writeUvSheet(head->skin->mesh(), path, progress);
    });
}

void MapExchange::editOutside()
{
    m_session.endPreviews();
    m_outside.begin();
}

} // namespace hairpaint::app
