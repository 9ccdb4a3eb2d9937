// New, open, save: see the header.
#include "app/project_files.h"

#include "app/background_task.h"
#include "app/library.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>

namespace hairpaint::app {

ProjectFiles::ProjectFiles(Session& session, Settings& settings, QWidget& window)
    : QObject(&window), m_session(session), m_settings(settings), m_window(window),
      m_encoded(model::makeEncodedLayers())
{}

QString ProjectFiles::displayName() const
{
    return m_path.isEmpty() ? tr("Untitled") : QFileInfo(m_path).completeBaseName();
}

void ProjectFiles::setThumbnailMaker(std::function<QImage()> maker)
{
    m_thumbnail = std::move(maker);
}

void ProjectFiles::setPath(const QString& path)
{
    m_path = path;
    if (!path.isEmpty()) {
        m_settings.addRecentFile(QFileInfo(path).absoluteFilePath());
        m_settings.setLastFolder(QFileInfo(path).absolutePath());
    }
    Q_EMIT pathChanged();
}

void ProjectFiles::newProject()
{
    if (mayDiscard())
        begin(starterProject());
}

bool ProjectFiles::newBaldProject()
{
    if (!mayDiscard())
        return false;
    begin(model::newProject());
    return true;
}

void ProjectFiles::begin(model::Project project)
{
    m_encoded = model::makeEncodedLayers();
    m_session.document().replace(std::move(project));
    setPath({});
}

void ProjectFiles::open()
{
    const QString path = QFileDialog::getOpenFileName(&m_window, tr("Open project"), m_settings.lastFolder(),
                                                      tr("Hair Paint projects (*.hairpaint)"));
    if (!path.isEmpty())
        openPath(path);
}

bool ProjectFiles::openPath(const QString& path)
{
    if (!mayDiscard())
        return false;
    auto encoded = model::makeEncodedLayers();
    bool cancelled = false;
    model::Result<model::Project> project = runInBackground<model::Project>(
        &m_window, tr("Opening %1…").arg(QFileInfo(path).fileName()),
        [&path, &encoded](const model::Progress& progress) {
            return model::loadProject(path, encoded.get(), progress);
        },
        &cancelled);
    if (cancelled)
        return false;
    if (!project) {
        m_settings.removeRecentFile(QFileInfo(path).absoluteFilePath());
        complain(project.error().message);
        return false;
    }
    m_encoded = std::move(encoded);
    m_session.document().replace(std::move(*project));
    setPath(path);
    return true;
}

bool ProjectFiles::save()
{
    return m_path.isEmpty() ? saveAs() : saveTo(m_path);
}

bool ProjectFiles::saveAs()
{
    const QString suggested =
        m_path.isEmpty() ? m_settings.lastFolder() + QLatin1Char('/') + displayName() + QStringLiteral(".hairpaint")
                         : m_path;
    QString path =
        QFileDialog::getSaveFileName(&m_window, tr("Save project"), suggested, tr("Hair Paint projects (*.hairpaint)"));
    if (path.isEmpty())
        return false;
    if (QFileInfo(path).suffix().isEmpty())
        path += QStringLiteral(".hairpaint");
    return saveTo(path);
}

bool ProjectFiles::mayDiscard()
{
    m_session.editor().commitStroke();
    if (!m_session.document().modified())
        return true;
    const auto answer = QMessageBox::question(
        &m_window, tr("Save changes?"), tr("'%1' has changes that are not saved.").arg(displayName()),
        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
    if (answer == QMessageBox::Save)
        return save();
    return answer == QMessageBox::Discard;
}

bool ProjectFiles::saveTo(const QString& path)
{
    m_session.editor().commitStroke();
    const QImage thumbnail = m_thumbnail ? m_thumbnail() : QImage();
    bool cancelled = false;
    // A copy shares tiles, so it is cheap, and the document may go on meanwhile.
    const model::Project project = m_session.document().committed();
    const model::Result<void> saved = runInBackground<void>(
        &m_window, tr("Saving %1…").arg(QFileInfo(path).fileName()),
        [&](const model::Progress& progress) {
            return model::saveProject(project, path, thumbnail, m_encoded.get(), progress);
        },
        &cancelled);
    if (!saved) {
        if (!cancelled)
            complain(saved.error().message);
        return false;
    }
    m_session.document().markSaved();
    setPath(path);
    return true;
}

void ProjectFiles::complain(const QString& message)
{
    QMessageBox::warning(&m_window, tr("Hair Paint"), message);
}

} // namespace hairpaint::app
