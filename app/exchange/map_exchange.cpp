// Dialogs, and the work behind them.
#include "app/exchange/map_exchange.h"

#include "model/document/layer_commands.h"
#include "model/exporting/uv_sheet.h"
#include "model/files/head_file.h"
#include "model/files/image_map.h"
#include "model/files/importer_client.h"
#include "model/files/map_names.h"
#include "model/files/map_source.h"
#include "model/files/tile_names.h"
#include "model/values/names.h"
#include "model/values/sentences.h"
#include "view/dialogs/map_table_dialog.h"

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

constexpr int kPreviewPixels = 256;

/// The layer as the map that it makes over nothing.
QImage previewOf(const sim::TiledRaster& layer, const model::MapSpec& spec)
{
    sim::TiledRaster resolved(layer.size(), spec.valueChannels);
    for (int y = 0; y < layer.size(); ++y)
        for (int x = 0; x < layer.size(); ++x) {
            const sim::Texel texel = layer.texel(x, y);
            resolved.setTexel(x, y,
                              texel[static_cast<std::size_t>(spec.valueChannels)] == 0 ? spec.defaultValue : texel);
        }
    QImage image(layer.size(), layer.size(), QImage::Format_RGB32);
    model::paintMapTexels(resolved, spec, false, {0, 0, layer.size(), layer.size()},
                          reinterpret_cast<QRgb*>(image.bits()), image.width());
    return image;
}

/// Empty where there is not enough memory.
view::ReadingPreview previewsOf(const model::MapSource& source, const model::MapSpec& spec)
{
    const auto one = [&](bool grey) {
        const model::Result<model::ImageLayer> layer = model::layerFromSource(source, spec, grey, kPreviewPixels);
        return layer ? previewOf(layer->raster, spec) : QImage();
    };
    return {.asScale = one(false), .asValue = one(true)};
}

model::MapSource sourceFrom(const QImage& image)
{
    const QImage small = image.scaled(kPreviewPixels, kPreviewPixels).convertToFormat(QImage::Format_RGBA64);
    model::ForeignImage foreign{.width = small.width(), .height = small.height(), .channels = 4, .pixels = {}};
    for (int y = 0; y < small.height(); ++y) {
        const auto* const pixels = reinterpret_cast<const QRgba64*>(small.constScanLine(y));
        for (int x = 0; x < small.width(); ++x)
            foreign.pixels.insert(foreign.pixels.end(),
                                  {pixels[x].red(), pixels[x].green(), pixels[x].blue(), pixels[x].alpha()});
    }
    model::MapSource source;
    source.images.push_back(std::move(foreign));
    return source;
}

/// An image that goes to a map.
struct ReadImage
{
    model::MapSource source;
    model::ImageReading reading = model::ImageReading::Scale;
    view::ReadingPreview preview; ///< Where it is either.
};

model::Result<ReadImage> readFor(const QString& path, const model::MapSpec& spec, const model::UvTiles& tiles,
                                 const model::Progress& progress)
{
    model::ImporterClient client;
    model::Result<model::MapSource> source = model::mapSourceFrom(client, path, spec, tiles, progress);
    if (!source)
        return tl::unexpected(source.error());
    ReadImage read{.source = std::move(*source), .preview = {}};
    read.reading = model::readingOf(read.source, spec);
    if (read.reading == model::ImageReading::Either)
        read.preview = previewsOf(read.source, spec);
    return read;
}

} // namespace

MapExchange::MapExchange(Session& session, FileWork& files)
    : QObject(&files), m_session(session), m_files(files), m_outside(session, files)
{}

QString MapExchange::noGroupText()
{
    return tr("There is no hair group whose map it could be; add one in the panel Hair.");
}

void MapExchange::importImage(std::optional<bool> grey)
{
    const QString path = m_files.askOpenPath(
        tr("Load image into %1").arg(model::mapSpec(m_session.editor().target().map()).titleText()),
        tr("Images (%1)").arg(QStringLiteral("*.") + model::imageEndings().join(QLatin1String(" *."))));
    if (!path.isEmpty())
        importImageFrom(path, grey);
}

void MapExchange::importImageFrom(const QString& path, std::optional<bool> grey)
{
    m_session.endPreviews(); // What is only shown is no target.
    importImageInto(path, grey, m_session.editor().target().address());
}

void MapExchange::importFolder()
{
    const QString folder = m_files.askFolder(tr("Load maps"));
    if (folder.isEmpty())
        return;
    QStringList patterns;
    for (const QString& ending : model::imageEndings())
        patterns += QStringLiteral("*.") + ending;
    QStringList paths;
    for (const QFileInfo& file : QDir(folder).entryInfoList(patterns, QDir::Files, QDir::Name))
        paths += file.filePath();
    if (paths.isEmpty())
        return m_files.complain(
            tr("There is no image in '%1'; choose a folder that holds some.").arg(model::shownPath(folder)));
    importImages(paths);
}

void MapExchange::importImages(const QStringList& paths)
{
    m_session.endPreviews();
    const model::Project& project = m_session.document().committed();
    if (project.groups.empty())
        return m_files.complain(noGroupText());
    std::size_t active = 0;
    QStringList names;
    std::vector<model::Id> groups;
    for (const model::HairGroup& group : project.groups) {
        if (group.id == m_session.editor().target().group())
            active = groups.size();
        groups.push_back(group.id);
        names += model::shownName(group.name);
    }
    std::vector<view::ImageForMap> images;
    for (const QString& path : model::tilePatternsOf(paths, model::tilesOf(project.head))) {
        const std::optional<model::NamedMap> named = model::mapNamedBy(path, project.groups);
        images.push_back({.path = path,
                          .map = named ? std::optional(named->kind) : std::nullopt,
                          .group = named && named->group ? *named->group : active});
    }
    view::MapTableDialog dialog(images, names, &m_files.window());
    if (dialog.exec() != QDialog::Accepted)
        return;
    for (const view::ImageForMap& image : dialog.choice())
        if (image.map)
            importImageInto(image.path, std::nullopt, {.group = groups[image.group], .map = *image.map, .layer = 0});
}

void MapExchange::importImageInto(const QString& told, std::optional<bool> grey, const model::LayerAddress& target)
{
    model::Document& document = m_session.document();
    const model::UvTiles tiles = model::tilesOf(document.committed().head);
    const QString path = model::tilePatternOf(told, tiles);
    const model::MapStack* map = mapOf(document, target);
    if (map == nullptr)
        return m_files.complain(noGroupText());
    const model::MapSpec& spec = model::mapSpec(target.map);
    const QString name = QFileInfo(path).fileName();
    std::optional<ReadImage> read = m_files.read<ReadImage>(
        path, [path, &spec, tiles](const model::Progress& progress) { return readFor(path, spec, tiles, progress); });
    if (!read)
        return;
    if (!grey && read->reading == model::ImageReading::Either) {
        grey = askReading(name, spec, read->preview);
        if (!grey)
            return;
    }
    map = mapOf(document, target); // The dialog lets time pass.
    if (map == nullptr)
        return;
    const bool isGrey = grey.value_or(read->reading == model::ImageReading::Value);
    const auto source = std::make_shared<const model::MapSource>(std::move(read->source));
    std::optional<model::ImageLayer> image = m_files.read<model::ImageLayer>(
        path, [source, &spec, isGrey, size = map->size](const model::Progress& /*progress*/) {
            return model::layerFromSource(*source, spec, isGrey, size);
        });
    if (!image)
        return;
    map = mapOf(document, target); // Much may have happened meanwhile.
    if (map == nullptr || map->size != image->raster.size())
        return;
    const QSize mapSize(map->size, map->size);
    const int top = static_cast<int>(map->layers.size());
    document.push(
        model::insertLayerCommand(document, target.group, target.map,
                                  {.id = 0, .name = model::mapTitleOf(path), .raster = std::move(image->raster)}, top,
                                  tr("Load %1 into %2").arg(name, spec.titleText())));
    if (!source->leftOut.empty())
        m_files.tell(QStringLiteral("%1: %2").arg(name, model::leftOutTiles(source->leftOut)));
    else if (image->imageSize != mapSize)
        m_files.tell(tr("%1 was resampled from %2 × %3 to %4 × %4; Map > Map size changes the map's")
                         .arg(name)
                         .arg(image->imageSize.width())
                         .arg(image->imageSize.height())
                         .arg(mapSize.width()));
}

std::optional<bool> MapExchange::askReading(const QString& name, const model::MapSpec& spec,
                                            const view::ReadingPreview& preview)
{
    view::ImageReadingDialog dialog(name, spec.titleText(), preview, &m_files.window());
    if (dialog.exec() != QDialog::Accepted)
        return std::nullopt;
    return dialog.isValue();
}

std::optional<model::Clip> MapExchange::clipFrom(const QImage& image)
{
    const model::LayerAddress target = m_session.editor().target().address();
    const model::MapStack* map = mapOf(m_session.document(), target);
    if (map == nullptr || image.isNull())
        return std::nullopt;
    const model::MapSpec& spec = model::mapSpec(target.map);
    const model::ImageReading reading = model::readingOf(image, spec);
    bool isGrey = reading == model::ImageReading::Value;
    if (reading == model::ImageReading::Either) {
        const std::optional<bool> told = askReading(tr("the copied image"), spec, previewsOf(sourceFrom(image), spec));
        if (!told)
            return std::nullopt;
        isGrey = *told;
    }
    const QRectF area = m_session.editor().tools().selection().rectangle().value_or(QRectF(0.0, 0.0, 1.0, 1.0));
    map = mapOf(m_session.document(), target); // The dialog lets time pass.
    return map == nullptr ? std::nullopt
                          : std::optional(model::clipFromImage(image, target.map, isGrey, map->size, area));
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
    view::ExportMapsDialog dialog({.map = model::mapSpec(editor.target().map()).titleText(),
                                   .group = model::shownName(group->name),
                                   .tiles = model::tilesOf(m_session.document().committed().head)},
                                  m_choice, &m_files.window());
    m_files.announce(dialog, view::HelpDialog::Topic::MapExport);
    if (dialog.exec() != QDialog::Accepted)
        return;
    m_choice = dialog.choice();
    const QString folder = m_files.askFolder(dialog.windowTitle());
    if (folder.isEmpty())
        return;
    const std::vector<model::WantedMap> maps = wantedMaps(m_choice.range);
    QStringList there = model::mapImageNames(maps, m_choice.options);
    const int count = static_cast<int>(maps.size());
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
