// Writing, watching and reading back.
#include "app/exchange/outside_edit.h"

#include "model/document/paint_command.h"
#include "model/files/image_map.h"
#include "model/values/names.h"
#include "model/values/sentences.h"

#include <QDesktopServices>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QScopedValueRollback>
#include <QUrl>

namespace hairpaint::app {

namespace {

QByteArray contentOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

OutsideEdit::OutsideEdit(Session& session, FileWork& files) : m_session(session), m_files(files)
{
    // Its layers have the same numbers, and are others.
    connect(&session.document(), &model::Document::changed, this, [this](const model::Change& change) {
        if (change.aspect == model::Change::Aspect::Everything)
            for (auto& [path, away] : m_away)
                away.layer.reset();
    });
}

void OutsideEdit::begin()
{
    const model::LayerAddress target = m_session.editor().target().address();
    const model::Layer* layer = m_session.document().committed().layer(target.group, target.map, target.layer);
    if (layer == nullptr)
        return m_files.complain(tr("There is no layer to be edited; add one in the panel Layers."));
    if (layer->locked)
        return m_files.complain(
            tr("The layer '%1' is locked; unlock it in the panel Layers first.").arg(model::shownName(layer->name)));
    if (m_folder == nullptr || !m_folder->isValid())
        m_folder = std::make_unique<QTemporaryDir>();
    if (!m_folder->isValid())
        return m_files.complain(
            model::cannotWrite(QDir::tempPath(), {.text = model::writeRefusal(m_folder->errorString())})
                .value()
                .message);
    const model::MapSpec& spec = model::mapSpec(target.map);
    const QString path =
        m_folder->filePath(QStringLiteral("%1-%2.png").arg(QLatin1StringView(spec.id)).arg(++m_number));
    const bool written = m_files.change(
        FileWork::writingOf(path), path, [raster = layer->raster, &spec, path](const model::Progress& progress) {
            return model::ImporterClient().writeImage(model::imageFromLayer(raster, spec), path, 16, progress);
        });
    if (!written)
        return;
    auto watch = std::make_unique<FileWatch>(m_files.jobs());
    connect(watch.get(), &FileWatch::looked, this, [this, path] { look(path); });
    watch->setPath(path);
    m_away[path] = {.layer = target, .bytes = contentOf(path), .watch = std::move(watch)};
    if (!QDesktopServices::openUrl(QUrl::fromLocalFile(path)))
        return m_files.complain(
            tr("The system knows no program that opens '%1'; open it yourself: what is saved there comes back.")
                .arg(QDir::toNativeSeparators(path)));
    m_files.tell(tr("%1 is open elsewhere: what is saved there comes back").arg(QFileInfo(path).fileName()));
}

void OutsideEdit::look(const QString& path)
{
    Away& away = m_away.at(path);
    const QByteArray bytes = contentOf(path);
    if (bytes.isEmpty() || bytes == away.bytes)
        return;
    if (m_isTaking)
        return away.watch->look();
    const QScopedValueRollback taking(m_isTaking, true);
    away.bytes = bytes;
    if (!away.layer)
        return m_files.complain(
            tr("The layer of '%1' is in another project; open that one and load the image into its map "
               "with File > Load image into map.")
                .arg(QDir::toNativeSeparators(path)));
    takeBack(path, *away.layer);
}

void OutsideEdit::takeBack(const QString& path, model::LayerAddress layer)
{
    m_session.endPreviews();
    const auto current = [this, &layer] {
        return m_session.document().committed().layer(layer.group, layer.map, layer.layer);
    };
    if (current() == nullptr)
        return m_files.complain(
            tr("The layer of '%1' is no longer there; undo what removed it and save the image again.")
                .arg(QFileInfo(path).fileName()));
    if (current()->locked)
        return m_files.complain(tr("The layer '%1' is locked; unlock it in the panel Layers and save '%2' again.")
                                    .arg(model::shownName(current()->name), QFileInfo(path).fileName()));
    const int size = current()->raster.size();
    std::optional<model::ImageLayer> read =
        m_files.read<model::ImageLayer>(path, [path, layer, size](const model::Progress& progress) {
            model::ImporterClient client;
            return model::layerFromFile(client, path, model::mapSpec(layer.map), false, size, progress);
        });
    if (!read)
        return;
    if (current() == nullptr || current()->raster.size() != size)
        return;
    replaceLayer(layer, std::move(read->raster));
    m_files.tell(tr("%1 came back").arg(QFileInfo(path).fileName()));
}

void OutsideEdit::replaceLayer(const model::LayerAddress& address, sim::TiledRaster raster)
{
    model::Document& document = m_session.document();
    const sim::TiledRaster& before = document.committed().layer(address.group, address.map, address.layer)->raster;
    model::LayerTiles tiles;
    for (int index = 0; index < raster.tileCount(); ++index) {
        raster.compact(index);
        if (!sim::sameTexels(*raster.tile(index), *before.tile(index)))
            tiles.emplace_back(index, raster.tile(index));
    }
    document.push(model::paintCommand(document, address, std::move(tiles),
                                      tr("Edit %1 elsewhere").arg(model::mapSpec(address.map).titleText())));
}

} // namespace hairpaint::app
