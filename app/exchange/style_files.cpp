// The user's own styles: see the header.
#include "app/exchange/style_files.h"

#include "app/styles/library.h"
#include "app/styles/style_pictures.h"
#include "model/disk/disk_sync.h"
#include "model/styles/style_transfer.h"
#include "model/values/names.h"
#include "model/values/sentences.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QInputDialog>
#include <QMessageBox>

#include <utility>

namespace hairpaint::app {

namespace {

constexpr qsizetype kMostTold = 10; ///< Sentences in a box.

} // namespace

StyleFiles::StyleFiles(Session& session, FileWork& files) : QObject(&files), m_session(session), m_files(files) {}

void StyleFiles::save()
{
    m_session.editor().tools().commitStroke();
    bool accepted = false;
    const QString name = QInputDialog::getText(&m_files.window(), tr("Save style"), tr("Name of the style"),
                                               QLineEdit::Normal, tr("My style"), &accepted)
                             .trimmed();
    if (!accepted || name.isEmpty())
        return;
    const QString folder = ownPresetFolder();
    if (!QDir().mkpath(folder))
        return m_files.complain(tr("The folder '%1' could not be made; check that you may write there.").arg(folder));
    const QString path = ownStylePath(name);
    if (QFile::exists(path) &&
        QMessageBox::question(&m_files.window(), tr("Save style"),
                              tr("There is a style '%1' already. Replace it?").arg(name)) != QMessageBox::Yes)
        return;
    // Without a picture: the strip has one drawn, framed as all the others are.
    const model::Project project = m_session.document().committed();
    const bool saved = m_files.change({.text = tr("Saving style %1").arg(name),
                                       .whenCancelled = tr("The style '%1' was not saved: cancelled").arg(name)},
                                      path, [project, name, path](const model::Progress& progress) {
                                          return model::savePreset(model::presetFrom(project, name), path, progress);
                                      });
    if (!saved)
        return;
    Q_EMIT changed();
    m_files.tell(tr("Style '%1' saved").arg(name));
}

void StyleFiles::carryOut(const QString& path, view::StyleOrder order)
{
    switch (order) {
    case view::StyleOrder::About: // No file changes.
        return;
    case view::StyleOrder::Rename:
        return rename(path);
    case view::StyleOrder::Tag:
        return tag(path);
    case view::StyleOrder::Replace:
        return replace(path);
    case view::StyleOrder::Picture:
        return takePicture(path);
    case view::StyleOrder::Export:
        return exportOne(path);
    case view::StyleOrder::Delete:
        return remove(path);
    }
}

void StyleFiles::rename(const QString& path)
{
    const QString before = styleName(path);
    bool accepted = false;
    const QString name = QInputDialog::getText(&m_files.window(), tr("Rename style"), tr("Name of the style"),
                                               QLineEdit::Normal, before, &accepted)
                             .trimmed();
    if (!accepted || name.isEmpty() || name == before)
        return;
    const QString there = ownStylePath(name);
    if (there != path && QFile::exists(there) &&
        QMessageBox::question(&m_files.window(), tr("Rename style"),
                              tr("There is a style '%1' already. Replace it?").arg(name)) != QMessageBox::Yes)
        return;
    m_files.change({.text = tr("Renaming %1").arg(before),
                    .whenCancelled = tr("The style '%1' was not renamed: cancelled").arg(before)},
                   path,
                   [path, name](const model::Progress& progress) { return app::renameStyle(path, name, progress); });
    if (there != path && QFile::exists(there) && !QFile::exists(path))
        Q_EMIT renamed(path, there);
    Q_EMIT changed(); // Also where it was cancelled: it may have come too late.
}

void StyleFiles::tag(const QString& path)
{
    const model::Result<model::PresetEntry> entry = model::presetEntry(path);
    if (!entry)
        return m_files.complain(entry.error().message);
    const QString name = model::shownName(entry->name);
    bool accepted = false;
    const QString text =
        QInputDialog::getText(&m_files.window(), tr("Tags"), tr("Words by which '%1' is found, with commas").arg(name),
                              QLineEdit::Normal, shownTags(entry->tags), &accepted);
    const QStringList tags = tagsFrom(text);
    if (!accepted || tags == entry->tags)
        return;
    changeFile(path,
               {.text = tr("Writing the tags of %1").arg(name),
                .whenCancelled = tr("The tags of '%1' were not changed: cancelled").arg(name)},
               tr("'%1' has other tags").arg(name),
               [tags](model::Preset& preset, const model::Progress& /*progress*/) { preset.tags = tags; });
}

void StyleFiles::replace(const QString& path)
{
    m_session.editor().tools().commitStroke();
    const QString name = styleName(path);
    const model::Project project = m_session.document().committed();
    changeFile(path,
               {.text = tr("Saving style %1").arg(name),
                .whenCancelled = tr("The style '%1' was not saved: cancelled").arg(name)},
               tr("'%1' is this hair now").arg(name),
               [project](model::Preset& preset, const model::Progress& /*progress*/) {
                   model::Preset replaced = model::presetFrom(project, preset.name);
                   replaced.tags = preset.tags;
                   preset = std::move(replaced);
               });
}

void StyleFiles::takePicture(const QString& path)
{
    const QString name = styleName(path);
    const model::Project project = m_session.document().committed();
    changeFile(path,
               {.text = tr("Drawing the style %1").arg(name),
                .whenCancelled = tr("The picture of '%1' was not changed: cancelled").arg(name)},
               tr("'%1' has a new picture").arg(name),
               [project, camera = m_camera()](model::Preset& preset, const model::Progress& progress) {
                   if (QImage picture = stylePictureFrom(preset, project, camera, progress); !picture.isNull())
                       preset.picture = std::move(picture);
               });
}

void StyleFiles::changeFile(const QString& path, const Doing& doing, const QString& sentence,
                            const std::function<void(model::Preset&, const model::Progress&)>& change)
{
    const Kept kept{.path = path, .at = m_copies.filePath(QFileInfo(path).fileName())};
    QFile::remove(kept.at);
    const bool isKept = QFile::copy(path, kept.at); // Else there is no undo; the change is wanted all the same.
    const bool isChanged = m_files.change(doing, path, [path, change](const model::Progress& progress) {
        return changeStyle(
            path, [&](model::Preset& preset) { change(preset, progress); }, progress);
    });
    if (isChanged && isKept)
        offerUndo(kept, sentence);
    Q_EMIT changed();
}

void StyleFiles::exportOne(const QString& path)
{
    const QString there =
        m_files.askSavePath({.title = tr("Export style"),
                             .suggestedPath = QFileInfo(ownStylePath(styleName(path))).completeBaseName(),
                             .filter = tr("Styles (*.hairpreset)"),
                             .suffix = QStringLiteral("hairpreset")});
    if (there.isEmpty())
        return;
    m_files.write(there, [path, there](const model::Progress& progress) -> model::Result<void> {
        const model::Result<model::Preset> preset = loadStyle(path);
        if (!preset)
            return tl::unexpected(preset.error());
        return model::savePreset(*preset, there, progress);
    });
}

void StyleFiles::exportOwn()
{
    const QString folder = m_files.askFolder(tr("Export my styles"));
    if (folder.isEmpty())
        return;
    m_files.write(folder, [folder](const model::Progress& progress) -> model::Result<void> {
        const std::vector<model::PresetEntry> all = listStyles();
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (progress && !progress(static_cast<double>(i) / static_cast<double>(all.size())))
                return model::cancelled(folder);
            if (all[i].folder != QLatin1String("own"))
                continue;
            if (model::Result<void> written = exportStyle(all[i].path, folder, progress); !written)
                return written;
        }
        return {};
    });
}

void StyleFiles::importStyles()
{
    const QStringList paths = m_files.askOpenPaths(tr("Import styles"), tr("Styles (*.hairpreset)"));
    if (!paths.isEmpty())
        importStyles(paths);
}

void StyleFiles::importStyles(const QStringList& paths)
{
    struct Report
    {
        int added = 0;
        QStringList problems;
    };
    const std::optional<Report> report =
        m_files.read<Report>(paths.front(), [paths](const model::Progress& progress) -> model::Result<Report> {
            Report report;
            for (const QString& path : paths) {
                if (progress && !progress(static_cast<double>(report.added) / static_cast<double>(paths.size())))
                    return model::cancelled(path);
                const model::Result<bool> added = importStyle(path, progress);
                if (!added)
                    report.problems.append(added.error().message);
                else if (*added)
                    ++report.added;
            }
            return report;
        });
    Q_EMIT changed(); // Also where it was cancelled: some may have come in.
    if (!report)
        return;
    m_files.tell(report->added > 0 || !report->problems.isEmpty()
                     ? tr("%Ln styles added to yours", nullptr, report->added)
                     : tr("You have these styles already"));
    if (!report->problems.isEmpty())
        m_files.complain(report->problems.mid(0, kMostTold).join(QLatin1Char('\n')));
}

void StyleFiles::remove(const QString& path)
{
    const QString name = styleName(path);
    Kept kept{.path = path, .at = {}, .isMoved = true};
    if (!QFile::moveToTrash(path, &kept.at))
        return m_files.complain(tr("'%1' could not be moved to the trash; delete it by hand.").arg(path));
    if (kept.at.isEmpty()) // This system does not tell where it lies.
        m_files.tell(tr("'%1' is in the trash").arg(name));
    else
        offerUndo(kept, tr("'%1' is in the trash").arg(name));
    Q_EMIT changed();
}

void StyleFiles::offerUndo(const Kept& kept, const QString& sentence)
{
    m_kept = kept;
    Q_EMIT undoOffered(sentence);
}

void StyleFiles::undo()
{
    const std::optional<Kept> kept = std::exchange(m_kept, std::nullopt);
    Q_EMIT undoOffered({});
    if (!kept)
        return;
    if (!kept->isMoved)
        (void)model::deleteFile(kept->path);
    if (!QFile::rename(kept->at, kept->path))
        return m_files.complain(
            tr("'%1' could not be brought back; it is '%2' now.").arg(QFileInfo(kept->path).fileName(), kept->at));
    if (kept->isMoved) { // What the trash of Linux' desktops notes of it.
        const QFileInfo was(kept->at);
        QFile::remove(was.path() + QStringLiteral("/../info/") + was.fileName() + QStringLiteral(".trashinfo"));
    }
    Q_EMIT changed();
}

void StyleFiles::applyFrom(const QString& path)
{
    m_session.editor().tools().commitStroke();
    std::optional<model::Preset> preset = m_files.read<model::Preset>(
        path, [path, head = m_session.document().committed().head](const model::Progress& progress) {
            model::Result<model::Preset> read = model::loadPreset(path);
            if (!read)
                return read;
            std::optional<model::Preset> carried = model::carriedPreset(std::move(*read), head, progress);
            return carried ? model::Result<model::Preset>(std::move(*carried)) : model::cancelled(path);
        });
    if (preset)
        Q_EMIT wanted(std::make_shared<const model::Preset>(std::move(*preset)));
}

} // namespace hairpaint::app
