// Import and export: see the header.
#include "app/exchange.h"

#include "app/background_task.h"
#include "app/heads.h"
#include "app/library.h"
#include "app/picture.h"
#include "model/commands/commands.h"
#include "model/files/hair_file.h"
#include "model/files/image_map.h"
#include "view/dialogs/head_import_dialog.h"

#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QMessageBox>

namespace hairpaint::app {

namespace {

constexpr QSize kPictureSize(2048, 2048);

} // namespace

Exchange::Exchange(Session& session, Settings& settings, QWidget& window)
    : QObject(&window), m_session(session), m_settings(settings), m_window(window)
{}

void Exchange::setPictureMaker(std::function<QImage(QSize)> maker)
{
    m_picture = std::move(maker);
}

void Exchange::importImage(bool grey)
{
    const QString path = askOpenPath(tr("Load image into %1").arg(mapSpec(m_session.editor().activeMap()).titleText()),
                                     tr("Images (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.tga *.bmp *.webp *.psd)"));
    if (!path.isEmpty())
        importImageFrom(path, grey);
}

void Exchange::importImageFrom(const QString& path, bool grey)
{
    m_session.editor().commitStroke();
    model::Document& document = m_session.document();
    const model::LayerAddress target = m_session.editor().target();
    const model::HairGroup* group = document.project().group(target.group);
    if (group == nullptr)
        return;
    const model::MapSpec& spec = model::mapSpec(target.map);
    const int size = group->map(target.map).size;
    bool cancelled = false;
    model::Result<sim::TiledRaster> raster = runInBackground<sim::TiledRaster>(
        &m_window, tr("Reading %1…").arg(QFileInfo(path).fileName()),
        [&](const model::Progress& progress) -> model::Result<sim::TiledRaster> {
            const model::Result<model::ForeignImage> image = model::ImporterClient().readImage(path, progress);
            if (!image)
                return tl::unexpected(image.error());
            return model::layerFromImage(*image, spec, grey, size);
        },
        &cancelled);
    if (cancelled)
        return;
    if (!raster)
        return complain(raster.error().message);
    model::Layer layer{.id = 0, .name = QFileInfo(path).completeBaseName(), .raster = std::move(*raster)};
    const int top = static_cast<int>(group->map(target.map).layers.size());
    document.push(model::insertLayerCommand(document, target.group, target.map, std::move(layer), top,
                                            tr("Load %1 into %2").arg(QFileInfo(path).fileName(), spec.titleText())));
}

void Exchange::exportMap()
{
    const view::EditorState& editor = m_session.editor();
    const model::MapSpec& spec = model::mapSpec(editor.activeMap());
    const QString path = askSavePath(tr("Save %1 as image").arg(spec.titleText()), QLatin1StringView(spec.id),
                                     tr("Images (*.png *.tif *.exr *.tga)"), QStringLiteral("png"));
    if (path.isEmpty())
        return;
    const auto resolved = m_session.document().resolved(editor.activeGroup(), editor.activeMap());
    const model::Result<void> written = runInBackground<void>(
        &m_window, tr("Writing %1…").arg(QFileInfo(path).fileName()), [&](const model::Progress&) {
            return model::ImporterClient().writeImage(model::imageFromMap(*resolved, spec), path);
        });
    if (!written)
        return complain(written.error().message);
    Q_EMIT done(tr("%1 written").arg(QFileInfo(path).fileName()));
}

void Exchange::importHead()
{
    const QString path =
        askOpenPath(tr("Import head"), tr("Meshes (*.glb *.gltf *.obj *.fbx *.ply *.dae *.3ds *.x3d)"));
    if (!path.isEmpty())
        importHeadFrom(path);
}

void Exchange::importHeadFrom(const QString& path)
{
    m_session.editor().commitStroke();
    bool cancelled = false;
    const QString name = QFileInfo(path).fileName();
    const model::Result<sim::HeadMesh> mesh = runInBackground<sim::HeadMesh>(
        &m_window, tr("Reading %1…").arg(name),
        [&path](const model::Progress& progress) { return model::ImporterClient().readMesh(path, progress); },
        &cancelled);
    if (cancelled)
        return;
    if (!mesh)
        return complain(mesh.error().message);
    view::HeadImportDialog dialog(*mesh, name, &m_window);
    Q_EMIT headDialogMade(dialog);
    if (dialog.exec() != QDialog::Accepted)
        return;
    const model::HeadGuess guess{.unitScale = dialog.unitScale(), .upAxis = dialog.upAxis()};
    const model::Result<ImportedHead> head =
        runInBackground<ImportedHead>(&m_window, tr("Preparing %1…").arg(name), [&](const model::Progress&) {
            return remakeHead(QFileInfo(path).completeBaseName(), model::writeGlb(*mesh), guess);
        });
    if (!head)
        return complain(head.error().message);
    model::Document& document = m_session.document();
    document.push(model::setHeadCommand(document, head->head, head->ellipsoids));
}

void Exchange::useBuiltInHead()
{
    m_session.editor().commitStroke();
    model::Document& document = m_session.document();
    document.push(model::setHeadCommand(document, model::builtInHead(), model::builtInEllipsoids()));
}

void Exchange::exportHair()
{
    const QString path = askSavePath(tr("Export hair"), tr("hair"), tr("Hair curves (*.hair)"), QStringLiteral("hair"));
    const std::shared_ptr<const sim::StrandFrame> frame = m_session.frame();
    if (path.isEmpty() || frame == nullptr)
        return;
    const model::Result<void> written =
        runInBackground<void>(&m_window, tr("Writing %1…").arg(QFileInfo(path).fileName()),
                              [&](const model::Progress&) { return model::writeHairFile(*frame, path); });
    if (!written)
        return complain(written.error().message);
    Q_EMIT done(tr("%1 written").arg(QFileInfo(path).fileName()));
}

void Exchange::savePicture()
{
    const QImage picture = m_picture(kPictureSize);
    if (picture.isNull())
        return complain(tr("There is no OpenGL on this machine to draw a picture with; install a graphics driver."));
    const QString path =
        askSavePath(tr("Save picture"), tr("hairstyle"), tr("PNG images (*.png)"), QStringLiteral("png"));
    if (path.isEmpty())
        return;
    if (const model::Result<void> written = writePicture(picture, path); !written)
        return complain(written.error().message);
    Q_EMIT done(tr("%1 written").arg(QFileInfo(path).fileName()));
}

void Exchange::saveStyle()
{
    m_session.editor().commitStroke();
    bool accepted = false;
    const QString name = QInputDialog::getText(&m_window, tr("Save style"), tr("Name of the style"), QLineEdit::Normal,
                                               tr("My style"), &accepted)
                             .trimmed();
    if (!accepted || name.isEmpty())
        return;
    const QString folder = ownPresetFolder();
    if (!QDir().mkpath(folder))
        return complain(tr("The folder '%1' could not be made; check that you may write there.").arg(folder));
    const QString path = ownStylePath(name);
    if (QFile::exists(path) &&
        QMessageBox::question(&m_window, tr("Save style"),
                              tr("There is a style '%1' already. Replace it?").arg(name)) != QMessageBox::Yes)
        return;
    // Without a picture: the strip has one drawn, framed as all the others are.
    const model::Preset preset = model::presetFrom(m_session.document().committed(), name);
    if (const model::Result<void> saved = model::savePreset(preset, path); !saved)
        return complain(saved.error().message);
    Q_EMIT stylesChanged();
    Q_EMIT done(tr("Style '%1' saved").arg(name));
}

void Exchange::renameStyle(const QString& path)
{
    const QString before = styleName(path);
    bool accepted = false;
    const QString name = QInputDialog::getText(&m_window, tr("Rename style"), tr("Name of the style"),
                                               QLineEdit::Normal, before, &accepted)
                             .trimmed();
    if (!accepted || name.isEmpty() || name == before)
        return;
    const QString there = ownStylePath(name);
    if (there != path && QFile::exists(there) &&
        QMessageBox::question(&m_window, tr("Rename style"),
                              tr("There is a style '%1' already. Replace it?").arg(name)) != QMessageBox::Yes)
        return;
    if (const model::Result<QString> renamed = app::renameStyle(path, name); !renamed)
        return complain(renamed.error().message);
    Q_EMIT stylesChanged();
}

void Exchange::deleteStyle(const QString& path)
{
    if (QMessageBox::question(&m_window, tr("Delete style"), tr("Move '%1' to the trash?").arg(styleName(path))) !=
        QMessageBox::Yes)
        return;
    if (!QFile::moveToTrash(path))
        return complain(tr("'%1' could not be moved to the trash; delete it by hand.").arg(path));
    Q_EMIT stylesChanged();
}

void Exchange::applyStyleFrom(const QString& path)
{
    m_session.editor().commitStroke();
    const model::Result<model::Preset> preset = model::loadPreset(path);
    if (!preset)
        return complain(preset.error().message);
    model::Document& document = m_session.document();
    document.push(model::applyPresetCommand(document, *preset));
}

void Exchange::complain(const QString& message)
{
    QMessageBox::warning(&m_window, tr("Hair Paint"), message);
}

QString Exchange::askSavePath(const QString& title, const QString& name, const QString& filter, const QString& suffix)
{
    QString path = QFileDialog::getSaveFileName(
        &m_window, title, m_settings.lastFolder() + QLatin1Char('/') + name + QLatin1Char('.') + suffix, filter);
    if (path.isEmpty())
        return {};
    if (QFileInfo(path).suffix().isEmpty())
        path += QLatin1Char('.') + suffix;
    m_settings.setLastFolder(QFileInfo(path).absolutePath());
    return path;
}

QString Exchange::askOpenPath(const QString& title, const QString& filter)
{
    const QString path =
        QFileDialog::getOpenFileName(&m_window, title, m_settings.lastFolder(), filter + tr(";;All files (*)"));
    if (!path.isEmpty())
        m_settings.setLastFolder(QFileInfo(path).absolutePath());
    return path;
}

} // namespace hairpaint::app
