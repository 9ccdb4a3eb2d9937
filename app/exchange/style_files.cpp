// The user's own styles: see the header.
#include "app/exchange/style_files.h"

#include "app/styles/library.h"
#include "model/styles/style_transfer.h"
#include "model/values/sentences.h"

#include <QDir>
#include <QFile>
#include <QInputDialog>
#include <QMessageBox>

namespace hairpaint::app {

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
    Q_EMIT changed(); // Also where it was cancelled: it may have come too late.
}

void StyleFiles::remove(const QString& path)
{
    if (QMessageBox::question(&m_files.window(), tr("Delete style"),
                              tr("Move '%1' to the trash?").arg(styleName(path))) != QMessageBox::Yes)
        return;
    if (!QFile::moveToTrash(path))
        return m_files.complain(tr("'%1' could not be moved to the trash; delete it by hand.").arg(path));
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
