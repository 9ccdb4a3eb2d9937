// New, open, save: see the header.
#include "app/project_files.h"

#include "app/library.h"
#include "app/recovery/repair_dialog.h"
#include "app/save_dialog.h"
#include "model/files/earlier_versions.h"
#include "model/repair/project_repair.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QUndoStack>

#include <utility>

namespace hairpaint::app {

namespace {

constexpr double kThumbnailFraction = 0.3; ///< Of saving, for its progress.

const QUndoCommand* newestStep(model::Document& document)
{
    const QUndoStack& steps = document.undoStack();
    return steps.index() > 0 ? steps.command(steps.index() - 1) : nullptr;
}

} // namespace

ProjectFiles::ProjectFiles(Session& session, Settings& settings, Jobs& jobs, QWidget& window)
    : QObject(&window), m_session(session), m_settings(settings), m_jobs(jobs), m_window(window),
      m_encoded(model::makeEncodedLayers())
{
    connect(&m_watch, &FileWatch::maybeChanged, this, &ProjectFiles::tellOfOutside);
}

QString ProjectFiles::displayName() const
{
    if (!path().isEmpty())
        return QFileInfo(path()).completeBaseName();
    return m_nameWithoutPath.isEmpty() ? tr("Untitled") : m_nameWithoutPath;
}

void ProjectFiles::setThumbnailMaker(std::function<Picture()> maker)
{
    m_thumbnail = std::move(maker);
}

void ProjectFiles::setPath(const QString& path, const QString& nameWithoutPath)
{
    m_file.set(path);
    m_watch.setPath(path);
    m_toldOfOutside.clear();
    m_nameWithoutPath = nameWithoutPath;
    if (!path.isEmpty()) {
        m_settings.addRecentFile(QFileInfo(path).absoluteFilePath());
        m_settings.setLastFolder(QFileInfo(path).absolutePath());
    }
    Q_EMIT pathChanged();
}

void ProjectFiles::newProject()
{
    if (!mayDiscard())
        return;
    begin(tr("Starting a new project"), starterProject);
}

bool ProjectFiles::newBaldProject()
{
    if (!mayDiscard())
        return false;
    return begin(tr("Starting a new project"), model::newProject);
}

bool ProjectFiles::begin(const QString& doing, const std::function<model::Project()>& make)
{
    return take(doing, model::makeEncodedLayers(), {},
                [&make](const model::Progress&) { return model::Result<model::Project>(make()); });
}

bool ProjectFiles::take(const QString& doing, std::shared_ptr<model::EncodedLayers> encoded, const QString& path,
                        const Work<model::Project>& read)
{
    struct Ready
    {
        model::Project project;
        model::ResolvedMaps maps;
    };
    std::optional<model::Result<Ready>> ready =
        m_jobs.await<Ready>(doing, [&read](const model::Progress& progress) -> model::Result<Ready> {
            model::Result<model::Project> project = read(progress);
            if (!project)
                return tl::unexpected(project.error());
            model::ResolvedMaps maps(*project);
            return Ready{.project = std::move(*project), .maps = std::move(maps)};
        });
    if (!ready)
        return false;
    if (!*ready) {
        if (!ready->error().isDamage) // For that there is more than words.
            complain(ready->error().message);
        return false;
    }
    m_encoded = std::move(encoded);
    m_session.document().replace(std::move((*ready)->project), std::move((*ready)->maps));
    setPath(path);
    return true;
}

void ProjectFiles::open()
{
    const QString path = QFileDialog::getOpenFileName(&m_window, tr("Open project"), m_settings.lastFolder(),
                                                      tr("Hair Paint projects (*.hairpaint)"));
    if (!path.isEmpty())
        openPath(path);
}

bool ProjectFiles::mayOpenTwice(const QString& path)
{
    if (QFileInfo(path) == QFileInfo(this->path()) || !OpenFile::isOpenElsewhere(path))
        return true;
    QMessageBox box(QMessageBox::Question, tr("Open project"),
                    tr("'%1' is open in another window. What is saved in one of them would replace what was saved in "
                       "the other.")
                        .arg(QFileInfo(path).completeBaseName()),
                    QMessageBox::Cancel, &m_window);
    const QPushButton* open = box.addButton(tr("&Open anyway"), QMessageBox::AcceptRole);
    box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    return box.clickedButton() == open;
}

ProjectFiles::Outside ProjectFiles::askAboutOutside()
{
    QMessageBox box(QMessageBox::Warning, tr("Save project"),
                    tr("'%1' was changed by another program since it was opened or saved here. Replacing it would lose "
                       "those changes.")
                        .arg(displayName()),
                    QMessageBox::Cancel, &m_window);
    const QPushButton* other = box.addButton(tr("&Save under another name..."), QMessageBox::AcceptRole);
    const QPushButton* replace = box.addButton(tr("&Replace"), QMessageBox::DestructiveRole);
    box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    return box.clickedButton() == replace ? Outside::Replace
           : box.clickedButton() == other ? Outside::SaveAs
                                          : Outside::Stop;
}

void ProjectFiles::tellOfOutside()
{
    if (m_saving)
        return;
    QString text;
    if (m_file.gone())
        text = tr("'%1' is no longer where it was; saving writes it again.").arg(displayName());
    else if (m_file.changedOutside())
        text = tr("'%1' was changed by another program; saving asks before it replaces that.").arg(displayName());
    if (std::exchange(m_toldOfOutside, text) != text && !text.isEmpty())
        Q_EMIT changedOutside(text);
}

bool ProjectFiles::openPath(const QString& path)
{
    if (!mayOpenTwice(path) || !mayDiscard())
        return false;
    const auto encoded = model::makeEncodedLayers();
    bool unreadable = false;
    std::optional<model::Error> damage;
    const bool taken =
        take(tr("Opening %1").arg(QFileInfo(path).fileName()), encoded, path, [&](const model::Progress& progress) {
            bool goesOn = true;
            model::Result<model::Project> project = model::loadProject(path, encoded.get(), [&](double done) {
                goesOn = goesOn && progress(done);
                return goesOn;
            });
            unreadable = !project && goesOn;
            if (unreadable && project.error().isDamage)
                damage = project.error();
            return project;
        });
    if (unreadable)
        m_settings.removeRecentFile(QFileInfo(path).absoluteFilePath());
    if (damage)
        return offerRepair(damage->message) && openRepaired(path);
    return taken;
}

bool ProjectFiles::restore(const model::RecoveredWork& work)
{
    const model::JournalState& state = work.steps.at(work.current);
    std::optional<model::Result<model::ResolvedMaps>> maps = m_jobs.await<model::ResolvedMaps>(
        tr("Restoring unsaved work"), [&state](const model::Progress&) -> model::Result<model::ResolvedMaps> {
            return model::ResolvedMaps(state.project);
        });
    if (!maps)
        return false;
    if (!*maps) {
        complain(maps->error().message);
        return false;
    }
    m_encoded = model::makeEncodedLayers();
    m_session.document().restore(work, std::move(**maps));
    setPath(state.path);
    return true;
}

bool ProjectFiles::openRepaired(const QString& path)
{
    struct Ready
    {
        model::RepairedProject repaired;
        model::ResolvedMaps maps;
    };
    std::optional<model::Result<Ready>> ready =
        m_jobs.await<Ready>(tr("Repairing %1").arg(QFileInfo(path).fileName()),
                            [&path](const model::Progress& progress) -> model::Result<Ready> {
                                model::Result<model::RepairedProject> repaired = model::repairProject(path, progress);
                                if (!repaired)
                                    return tl::unexpected(repaired.error());
                                model::ResolvedMaps maps(repaired->project);
                                return Ready{.repaired = std::move(*repaired), .maps = std::move(maps)};
                            });
    if (!ready)
        return false;
    if (!*ready) {
        complain(ready->error().message);
        return false;
    }
    model::RepairedProject& repaired = (*ready)->repaired;
    m_encoded = model::makeEncodedLayers();
    model::RecoveredWork work;
    work.steps.emplace_back().project = std::move(repaired.project);
    m_session.document().restore(work, std::move((*ready)->maps));
    m_settings.setLastFolder(QFileInfo(path).absolutePath());
    setPath({}, tr("%1 (repaired)").arg(QFileInfo(path).completeBaseName()));
    RepairDialog(path, repaired.losses, &m_window).exec();
    return true;
}

bool ProjectFiles::save()
{
    if (path().isEmpty())
        return saveAs();
    if (m_file.changedOutside()) {
        const Outside answer = askAboutOutside();
        if (answer != Outside::Replace)
            return answer == Outside::SaveAs && saveAs();
    }
    return saveTo(path());
}

bool ProjectFiles::saveAs()
{
    const QString suggested =
        path().isEmpty() ? m_settings.lastFolder() + QLatin1Char('/') + displayName() + QStringLiteral(".hairpaint")
                         : path();
    const QString path = askSavePath(m_window, {.title = tr("Save project"),
                                                .suggestedPath = suggested,
                                                .filter = tr("Hair Paint projects (*.hairpaint)"),
                                                .suffix = QStringLiteral("hairpaint")});
    return !path.isEmpty() && saveTo(path);
}

bool ProjectFiles::mayDiscard()
{
    m_session.document().settle();
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
    // The picture is to show what is saved.
    const std::shared_ptr<const void> whole = m_session.wholeHair();
    const QString saving = tr("Saving %1").arg(QFileInfo(path).fileName());
    const bool came = m_jobs.awaitUntil(saving, [this] {
        m_session.endPreviews(); // Also those that come late.
        return m_session.hair() != Session::Hair::Underway;
    });
    if (!came)
        return false;
    const Picture picture = m_thumbnail ? m_thumbnail() : Picture();
    // A copy shares tiles, so it is cheap, and the document may go on meanwhile.
    model::Document& document = m_session.document();
    const model::Project project = document.committed();
    const QUndoCommand* newest = newestStep(document);
    const bool keepsEarlier = m_settings.preferences().earlierVersions;
    const QScopedValueRollback saves(m_saving, true);
    const std::optional<model::Result<void>> saved =
        m_jobs.await<void>(saving, [&](const model::Progress& progress) -> model::Result<void> {
            const QImage thumbnail =
                picture ? picture([&](double drawn) { return progress(drawn * kThumbnailFraction); }) : QImage();
            if (keepsEarlier)
                if (const model::Checked<void> kept = model::keepEarlierVersions(path); !kept)
                    return model::cannotWrite(model::earlierVersion(path, 1), kept.error());
            return model::saveProject(project, path, thumbnail, m_encoded.get(), [&](double written) {
                return progress(kThumbnailFraction + written * (1.0 - kThumbnailFraction));
            });
        });
    if (!saved)
        return false;
    if (!*saved)
        return offerAnotherPlace(saved->error().message) && saveAs();
    // A number that was being typed may have become a step meanwhile, which the file does not hold.
    if (newestStep(document) == newest)
        document.markSaved();
    setPath(path);
    return true;
}

bool ProjectFiles::offerAnotherPlace(const QString& problem)
{
    QMessageBox box(QMessageBox::Warning, tr("Save project"), problem, QMessageBox::Cancel, &m_window);
    const QPushButton* other = box.addButton(tr("&Save under another name..."), QMessageBox::AcceptRole);
    box.exec();
    return box.clickedButton() == other;
}

bool ProjectFiles::offerRepair(const QString& problem)
{
    QMessageBox box(QMessageBox::Warning, tr("Open project"), problem, QMessageBox::Cancel, &m_window);
    box.setInformativeText(tr("What is left of it can be opened as a new project; the file stays as it is."));
    const QPushButton* repair = box.addButton(tr("&Open what can be read"), QMessageBox::AcceptRole);
    box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    return box.clickedButton() == repair;
}

void ProjectFiles::complain(const QString& message)
{
    QMessageBox::warning(&m_window, tr("Hair Paint"), message);
}

} // namespace hairpaint::app
