// Import and export: see the header.
#include "app/exchange.h"

#include "app/background/heads.h"
#include "app/blender_addon.h"
#include "app/hair_export.h"
#include "app/library.h"
#include "app/picture.h"
#include "app/style_pictures.h"
#include "model/commands/commands.h"
#include "model/files/glb.h"
#include "model/files/image_map.h"
#include "model/files/sentences.h"
#include "model/importing/curve_import.h"
#include "model/importing/curve_reader.h"
#include "model/style_transfer.h"
#include "view/dialogs/hair_import_dialog.h"
#include "view/dialogs/head_import_dialog.h"
#include "view/dialogs/landmarks_dialog.h"

#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QMessageBox>

namespace hairpaint::app {

namespace {

constexpr QSize kPictureSize(2048, 2048);

/// Null where there is no such group any more.
const model::MapStack* mapOf(const model::Document& document, const model::LayerAddress& address)
{
    const model::HairGroup* group = document.committed().group(address.group);
    return group != nullptr ? &group->map(address.map) : nullptr;
}

} // namespace

Exchange::Exchange(Session& session, Settings& settings, Jobs& jobs, QWidget& window)
    : QObject(&window), m_session(session), m_settings(settings), m_jobs(jobs), m_window(window)
{}

void Exchange::setSceneSource(std::function<rendering::Scene()> source)
{
    m_scene = std::move(source);
}

QString Exchange::noGroupText()
{
    return tr("There is no hair group whose map it could be; add one in the panel Hair.");
}

void Exchange::importImage(bool grey)
{
    const QString path =
        askOpenPath(tr("Load image into %1").arg(model::mapSpec(m_session.editor().activeMap()).titleText()),
                    tr("Images (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.tga *.bmp *.webp *.psd)"));
    if (!path.isEmpty())
        importImageFrom(path, grey);
}

void Exchange::importImageFrom(const QString& path, bool grey)
{
    model::Document& document = m_session.document();
    m_session.endPreviews(); // What is only shown is no target.
    const model::LayerAddress target = m_session.editor().target();
    const model::MapStack* map = mapOf(document, target);
    if (map == nullptr)
        return complain(noGroupText());
    const model::MapSpec& spec = model::mapSpec(target.map);
    const QString name = QFileInfo(path).fileName();
    std::optional<model::Result<model::ImageLayer>> read = m_jobs.await<model::ImageLayer>(
        tr("Reading %1").arg(name), [&path, &spec, grey, size = map->size](const model::Progress& progress) {
            return model::layerFromFile(path, spec, grey, size, progress);
        });
    if (!read)
        return;
    if (!*read)
        return complain(read->error().message);
    map = mapOf(document, target); // Much may have happened meanwhile.
    model::ImageLayer& image = **read;
    if (map == nullptr || map->size != image.raster.size())
        return;
    const QSize mapSize(map->size, map->size);
    const int top = static_cast<int>(map->layers.size());
    document.push(model::insertLayerCommand(
        document, target.group, target.map,
        {.id = 0, .name = QFileInfo(path).completeBaseName(), .raster = std::move(image.raster)}, top,
        tr("Load %1 into %2").arg(name, spec.titleText())));
    if (image.imageSize != mapSize)
        Q_EMIT done(tr("%1 was resampled from %2 × %3 to %4 × %4; Map > Map size changes the map's")
                        .arg(name)
                        .arg(image.imageSize.width())
                        .arg(image.imageSize.height())
                        .arg(mapSize.width()));
}

void Exchange::exportMap()
{
    const view::EditorState& editor = m_session.editor();
    const model::MapSpec& spec = model::mapSpec(editor.activeMap());
    const QString path = askSavePath({.title = tr("Save %1 as image").arg(spec.titleText()),
                                      .suggestedPath = QLatin1StringView(spec.id),
                                      .filter = tr("Images (*.png *.tif *.exr *.tga)"),
                                      .suffix = QStringLiteral("png"),
                                      .otherSuffixes = {QStringLiteral("tiff")}});
    if (path.isEmpty())
        return;
    m_session.endPreviews(); // What is only shown is no part of the map.
    const auto resolved = m_session.document().resolvedNow(editor.activeGroup(), editor.activeMap());
    if (resolved == nullptr)
        return complain(noGroupText());
    write(path, [&](const model::Progress& progress) {
        return model::ImporterClient().writeImage(model::imageFromMap(*resolved, spec), path, 16, progress);
    });
}

void Exchange::write(const QString& path, const Work<void>& work)
{
    const QString name = QFileInfo(path).fileName();
    const std::optional<model::Result<void>> written = m_jobs.await<void>(tr("Writing %1").arg(name), work);
    if (written && !*written)
        complain(written->error().message);
    else if (written)
        Q_EMIT done(tr("%1 written").arg(name));
}

void Exchange::importHead()
{
    const QString path =
        askOpenPath(tr("Import head"), tr("Meshes (*.glb *.gltf *.vrm *.obj *.fbx *.ply *.dae *.3ds *.x3d)"));
    if (!path.isEmpty())
        importHeadFrom(path);
}

void Exchange::importHeadFrom(const QString& path)
{
    m_session.editor().commitStroke();
    const QString name = QFileInfo(path).fileName();
    const std::optional<model::Result<model::RiggedMesh>> mesh =
        m_jobs.await<model::RiggedMesh>(tr("Reading %1").arg(name), [&path](const model::Progress& progress) {
            return model::ImporterClient().readMesh(path, progress);
        });
    if (!mesh)
        return;
    if (!*mesh)
        return complain(mesh->error().message);
    view::HeadImportDialog dialog(**mesh, name, &m_window);
    Q_EMIT dialogMade(dialog, view::HelpDialog::Topic::HeadImport);
    if (dialog.exec() != QDialog::Accepted)
        return;
    const model::HeadGuess guess{.unitScale = dialog.unitScale(), .upAxis = dialog.upAxis()};
    const std::optional<model::Result<ImportedHead>> made =
        m_jobs.await<ImportedHead>(tr("Preparing %1").arg(name), [&](const model::Progress& progress) {
            return remakeHead(QFileInfo(path).completeBaseName(), model::glbFromMesh(**mesh), guess, progress);
        });
    if (!made)
        return;
    if (!*made)
        return complain(made->error().message);
    std::shared_ptr<const model::Head> head = (*made)->head;
    if (dialog.carriesHair() && (head = withLandmarksAsked(head)) == nullptr)
        return;
    replaceHead(head, (*made)->ellipsoids, dialog.carriesHair());
}

std::shared_ptr<const model::Head> Exchange::withLandmarksAsked(const std::shared_ptr<const model::Head>& head)
{
    view::LandmarksDialog dialog(head, &m_window);
    Q_EMIT dialogMade(dialog, view::HelpDialog::Topic::HeadImport);
    if (dialog.exec() != QDialog::Accepted)
        return nullptr;
    return head->landmarks == dialog.landmarks() ? head : model::withLandmarks(*head, dialog.landmarks());
}

void Exchange::moveLandmarks()
{
    m_session.editor().commitStroke();
    const model::Project& project = m_session.document().committed();
    if (project.head == nullptr || project.head->builtIn)
        return;
    const std::shared_ptr<const model::Head> head = withLandmarksAsked(project.head);
    if (head != nullptr && head != project.head)
        replaceHead(head, project.ellipsoids, true);
}

void Exchange::useBuiltInHead(const model::NamedHead& named)
{
    m_session.editor().commitStroke();
    using HeadPtr = std::shared_ptr<const model::Head>;
    const std::optional<model::Result<HeadPtr>> head = m_jobs.await<HeadPtr>(
        tr("Preparing %1").arg(named.title), [&named](const model::Progress&) -> model::Result<HeadPtr> {
            const model::Checked<HeadPtr> known = model::builtInHead(named.name);
            return known ? model::Result<HeadPtr>(*known) : model::cannotOpen(named.title, known.error());
        });
    if (!head)
        return;
    if (!*head)
        return complain(head->error().message);
    replaceHead(**head, model::builtInEllipsoids(named.name), true);
}

void Exchange::replaceHead(const std::shared_ptr<const model::Head>& head, std::vector<sim::Ellipsoid> ellipsoids,
                           bool carriesHair)
{
    using Groups = std::vector<model::HairGroup>;
    model::Document& document = m_session.document();
    m_session.endPreviews(); // What is only shown does not go along.
    std::optional<Groups> groups;
    if (carriesHair && document.committed().head && !document.committed().head->landmarks)
        Q_EMIT done(tr("The head so far has no landmarks; the maps stay as they lie"));
    // A style that was on its way may come while the hair is carried: what is there then counts.
    for (model::Project before; carriesHair && !(groups && before.groups == document.committed().groups);) {
        before = document.committed();
        std::optional<model::Result<Groups>> carried = m_jobs.await<Groups>(
            tr("Carrying the hair over"), [&before, &head](const model::Progress& progress) -> model::Result<Groups> {
                std::optional<Groups> moved = model::carriedGroups(before.groups, before.head, head, progress);
                return moved ? model::Result<Groups>(std::move(*moved)) : model::cancelled(head->name);
            });
        if (!carried)
            return;
        if (!*carried)
            return complain(carried->error().message);
        groups = std::move(**carried);
    }
    document.push(model::setHeadCommand(document, head, std::move(ellipsoids), std::move(groups)));
}

std::shared_ptr<const sim::StrandFrame> Exchange::currentHair()
{
    const std::shared_ptr<const void> whole = m_session.wholeHair();
    const bool came = m_jobs.awaitUntil(tr("Waiting for the newest hair"), [this] {
        m_session.endPreviews(); // Also those that come late.
        return m_session.hair() != Session::Hair::Underway;
    });
    if (!came)
        return nullptr;
    if (m_session.hair() == Session::Hair::Current)
        return m_session.frame();
    complain(tr("There is not enough memory for this hair; take less density or smaller maps."));
    return nullptr;
}

void Exchange::exportHair()
{
    const std::shared_ptr<const sim::StrandFrame> frame = currentHair();
    if (frame == nullptr)
        return;
    const model::Project project = m_session.document().committed();
    m_export.author = m_settings.avatarAuthor();
    view::ExportHairDialog dialog(exportableGroups(project, *frame), m_export, &m_window);
    dialog.setAvatarProblem(avatarProblem(project));
    Q_EMIT dialogMade(dialog, view::HelpDialog::Topic::HairExport);
    const int answer = dialog.exec();
    if (answer == QDialog::Rejected)
        return;
    view::HairExportChoice choice = dialog.choice();
    m_export = choice;
    m_settings.setAvatarAuthor(choice.author);
    if (answer == view::ExportHairDialog::kPreview)
        return previewChosen(frame);
    const QString suffix = QString::fromLatin1(choice.request.format->suffix);
    const QString path =
        askSavePath({.title = tr("Export hair"),
                     .suggestedPath = choice.request.format->isAvatar ? project.head->name : tr("hair"),
                     .filter = QStringLiteral("%1 (*.%2)").arg(choice.request.format->titleText(), suffix),
                     .suffix = suffix,
                     .otherSuffixes = model::exportSuffixes()});
    if (path.isEmpty())
        return;
    // The name's ending may tell of another format.
    if (const model::ExportFormat* named = model::findExportFormat(path, choice.request.format))
        choice.request.format = named;
    write(path, [&](const model::Progress& progress) { return exportChosen(project, frame, choice, path, progress); });
}

void Exchange::previewCards()
{
    const std::shared_ptr<const sim::StrandFrame> frame = currentHair();
    if (frame == nullptr)
        return;
    model::CurveOptions& curves = m_export.request.curves;
    curves = {};
    for (const view::ExportableGroup& group : exportableGroups(m_session.document().committed(), *frame))
        curves.groups.push_back({.id = group.id, .name = group.name});
    previewChosen(frame);
}

void Exchange::previewChosen(const std::shared_ptr<const sim::StrandFrame>& frame)
{
    using CardsPtr = std::shared_ptr<const rendering::CardSet>;
    const model::Project project = m_session.document().committed();
    const std::optional<model::Result<CardsPtr>> cards =
        m_jobs.await<CardsPtr>(tr("Making cards"), [&](const model::Progress& progress) {
            return cardsChosen(project, frame, m_export, progress);
        });
    if (!cards)
        return;
    if (!*cards)
        return complain(cards->error().message);
    if ((**cards)->triangles.empty())
        return complain(tr("There is no hair to make cards of; paint some density first."));
    Q_EMIT cardsMade(**cards);
}

void Exchange::importHair()
{
    const QString patterns = QStringLiteral("*.") + model::curveFileEndings().join(QLatin1String(" *."));
    if (const QString path = askOpenPath(tr("Import hair"), tr("Hair curves (%1)").arg(patterns)); !path.isEmpty())
        importHairFrom(path);
}

void Exchange::importHairFrom(const QString& path)
{
    using Groups = std::vector<model::HairGroup>;
    model::Document& document = m_session.document();
    m_session.endPreviews(); // What is only shown is no ground to add to.
    const QString name = QFileInfo(path).fileName();
    view::HairImportDialog dialog(name, &m_window);
    Q_EMIT dialogMade(dialog, view::HelpDialog::Topic::HairImport);
    if (dialog.exec() != QDialog::Accepted)
        return;
    const model::CurveSpaceChoice choice = dialog.choice();
    const std::shared_ptr<const model::Head> head = document.committed().head;
    std::optional<model::Result<Groups>> groups =
        m_jobs.await<Groups>(tr("Reading %1").arg(name), [&](const model::Progress& progress) {
            return model::groupsFromCurves(path, choice, head, progress);
        });
    if (!groups)
        return;
    if (!*groups)
        return complain(groups->error().message);
    if (document.committed().head != head)
        return complain(tr("The head was replaced while '%1' was read; import it again.").arg(name));
    const std::size_t before = document.committed().groups.size();
    document.push(model::importHairCommand(document, std::move(**groups), name));
    if (document.committed().groups.size() > before)
        m_session.editor().setActiveGroup(document.committed().groups[before].id);
    Q_EMIT done(tr("%1 imported").arg(name));
}

void Exchange::installBlenderAddon()
{
    const QStringList folders = blenderAddonFolders();
    if (folders.isEmpty()) {
        const QString name = blenderAddonName();
        const QString path = askSavePath({.title = tr("Save Blender add-on"),
                                          .suggestedPath = QFileInfo(name).completeBaseName(),
                                          .filter = tr("Python scripts (*.py)"),
                                          .suffix = QFileInfo(name).suffix()});
        if (!path.isEmpty())
            write(path, [&path](const model::Progress&) { return saveBlenderAddon(path); });
        return;
    }
    QStringList versions;
    for (const QString& folder : folders) {
        if (const model::Result<void> installed = app::installBlenderAddon(folder); !installed)
            return complain(installed.error().message);
        versions += blenderVersionOf(folder);
    }
    QMessageBox::information(&m_window, tr("Blender add-on"),
                             tr("The add-on is installed in Blender %1. Turn on “Hair Paint hair” there under Edit > "
                                "Preferences > Add-ons; then File > Import reads hair that is exported as .hair.")
                                 .arg(versions.join(QLatin1String(", "))));
}

void Exchange::savePicture()
{
    const QString transparent = tr("PNG images without background (*.png)");
    const QStringList filters{tr("PNG images (*.png)"), transparent,
                              tr("OpenEXR images in linear light, without background (*.exr)")};
    QString filter;
    const QString path = askSavePath({.title = tr("Save picture"),
                                      .suggestedPath = tr("hairstyle"),
                                      .filter = filters.join(QLatin1String(";;")),
                                      .suffix = QStringLiteral("png")},
                                     &filter);
    if (path.isEmpty() || currentHair() == nullptr)
        return;
    rendering::Scene scene = m_scene();
    scene.transparent = isExr(path) || filter == transparent;
    write(path, [scene, path](const model::Progress& progress) {
        return PictureMaker().save(scene, kPictureSize, {}, path, progress);
    });
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
    const model::Project project = m_session.document().committed();
    const std::optional<model::Result<void>> saved = m_jobs.await<void>(
        tr("Saving style %1").arg(name), [&](const model::Progress& progress) -> model::Result<void> {
            const model::Preset preset = model::presetFrom(project, name);
            if (!progress(1.0))
                return model::cancelled(path);
            return model::savePreset(preset, path);
        });
    if (!saved)
        return;
    if (!*saved)
        return complain(saved->error().message);
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
    const std::optional<model::Result<QString>> renamed = m_jobs.await<QString>(
        tr("Renaming %1").arg(before), [&path, &name](const model::Progress&) { return app::renameStyle(path, name); });
    Q_EMIT stylesChanged(); // Also where it was cancelled: it may have come too late.
    if (renamed && !*renamed)
        complain(renamed->error().message);
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
    const std::optional<model::Result<model::Preset>> preset = m_jobs.await<model::Preset>(
        tr("Reading %1").arg(QFileInfo(path).fileName()),
        [&path, head = m_session.document().committed().head](const model::Progress& progress) {
            model::Result<model::Preset> read = model::loadPreset(path);
            if (!read)
                return read;
            std::optional<model::Preset> carried = model::carriedPreset(std::move(*read), head, progress);
            return carried ? model::Result<model::Preset>(std::move(*carried)) : model::cancelled(path);
        });
    if (!preset)
        return;
    if (!*preset)
        return complain(preset->error().message);
    model::Document& document = m_session.document();
    document.push(model::applyPresetCommand(document, **preset));
}

void Exchange::complain(const QString& message)
{
    QMessageBox::warning(&m_window, tr("Hair Paint"), message);
}

QString Exchange::askSavePath(SaveQuestion question, QString* chosenFilter)
{
    question.suggestedPath =
        m_settings.lastFolder() + QLatin1Char('/') + question.suggestedPath + QLatin1Char('.') + question.suffix;
    const QString path = app::askSavePath(m_window, question, chosenFilter);
    if (!path.isEmpty())
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
