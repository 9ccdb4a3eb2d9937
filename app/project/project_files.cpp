// New, open, save: see the header.
#include "app/project/project_files.h"

#include "app/recovery/repair_dialog.h"
#include "app/settings/file_dialogs.h"
#include "app/styles/library.h"
#include "model/disk/earlier_versions.h"
#include "model/files/encoded_layers.h"
#include "model/repair/project_repair.h"

#include <QFileInfo>
#include <QScopedValueRollback>
#include <QStandardPaths>
#include <QUndoStack>

#include <algorithm>
#include <utility>

namespace hairpaint::app {

namespace {

constexpr double kThumbnailFraction = 0.3; ///< Fraction of saving that is done once the thumbnail is drawn.

const QUndoCommand* newestStep(model::Document& document)
{
    const QUndoStack& steps = document.undoStack();
    return steps.index() > 0 ? steps.command(steps.index() - 1) : nullptr;
}

} // namespace

ProjectFiles::ProjectFiles(Session& session, Settings& settings, Jobs& jobs, QWidget& window)
    : QObject(&window), m_session(session), m_settings(settings), m_jobs(jobs), m_window(window), m_questions(window),
      m_watch(jobs), m_encoded(model::makeEncodedLayers())
{
    connect(&m_watch, &FileWatch::looked, this, &ProjectFiles::tellOfOutside);
}

Doing ProjectFiles::startingOfNew()
{
    return {.text = tr("Starting a new project"), .whenCancelled = tr("No new project was started: cancelled")};
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

void ProjectFiles::setPath(const QString& path, const QString& nameWithoutPath, const FileStamp& stamp)
{
    m_file.set(path, stamp);
    m_asRestored = {};
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
    begin(startingOfNew(), starterProject);
}

bool ProjectFiles::newBaldProject()
{
    if (!mayDiscard())
        return false;
    return begin(startingOfNew(), baldProject);
}

bool ProjectFiles::begin(const Doing& doing, const std::function<model::Project()>& make)
{
    const Taken taken = take(doing, model::makeEncodedLayers(), {},
                             [make](const model::Progress&) { return model::Result<model::Project>(make()); });
    if (taken.problem)
        m_questions.complain(taken.problem->message);
    return taken.isOpen;
}

Doing ProjectFiles::openingOf(const QString& path)
{
    const QString name = QFileInfo(path).fileName();
    return {.text = tr("Opening %1").arg(name),
            .whenCancelled = tr("The project '%1' was not opened: cancelled").arg(name)};
}

ProjectFiles::Taken ProjectFiles::take(const Doing& doing, std::shared_ptr<model::EncodedLayers> encoded,
                                       const QString& path, Work<model::Project> read)
{
    Q_EMIT openingBegan(doing.text);
    Taken taken = takeQuietly(doing, std::move(encoded), path, std::move(read));
    Q_EMIT openingEnded(taken.isOpen);
    return taken;
}

ProjectFiles::Taken ProjectFiles::takeQuietly(const Doing& doing, std::shared_ptr<model::EncodedLayers> encoded,
                                              const QString& path, Work<model::Project> read)
{
    struct Ready
    {
        model::Project project;
        model::ResolvedMaps maps;
        FileStamp stamp;
    };
    Awaited<Ready> ready = m_jobs.awaitOrLeave<Ready>(
        doing, [read = std::move(read), path](const model::Progress& progress) -> model::Result<Ready> {
            model::Result<model::Project> project = read(progress);
            if (!project)
                return tl::unexpected(project.error());
            model::ResolvedMaps maps(*project);
            return Ready{.project = std::move(*project), .maps = std::move(maps), .stamp = stampOf(path)};
        });
    if (ready.end == WorkEnd::Left)
        return {.isOpen = false, .problem = model::cannotOpen(path, model::silentDisk()).value()};
    if (ready.end == WorkEnd::Cancelled)
        return {};
    if (!*ready.result)
        return {.isOpen = false, .problem = ready.result->error()};
    m_encoded = std::move(encoded);
    m_session.document().replace(std::move((*ready.result)->project), std::move((*ready.result)->maps));
    setPath(path, {}, (*ready.result)->stamp);
    return {.isOpen = true, .problem = std::nullopt};
}

void ProjectFiles::open()
{
    const QString path =
        FileDialogs(m_window, m_jobs)
            .askOpenPath(tr("Open project"), m_settings.lastFolder(), tr("Hair Paint projects (*.hairpaint)"));
    if (!path.isEmpty())
        openPath(path);
}

bool ProjectFiles::isOpen(const QString& path)
{
    if (path == this->path() || this->path().isEmpty())
        return path == this->path();
    const Awaited<bool> same = m_jobs.awaitOrLeave<bool>(
        openingOf(path), [one = path, other = this->path()](const model::Progress&) -> model::Result<bool> {
            return stampOf(one).wholeName == stampOf(other).wholeName;
        });
    return same.end == WorkEnd::Done && *same.result && **same.result;
}

bool ProjectFiles::mayOpenTwice(const QString& path)
{
    const Awaited<FileStamp> stamp = m_jobs.awaitOrLeave<FileStamp>(
        openingOf(path), [path](const model::Progress&) -> model::Result<FileStamp> { return stampOf(path); });
    if (stamp.end == WorkEnd::Left)
        m_questions.complain(model::cannotOpen(path, model::silentDisk()).value().message);
    if (stamp.end != WorkEnd::Done || !*stamp.result)
        return false;
    const FileStamp& file = **stamp.result;
    if (file.wholeName == m_file.stamp().wholeName || !OpenFile::isOpenElsewhere(file))
        return true;
    return m_questions.mayOpenTwice(QFileInfo(path).completeBaseName());
}

bool ProjectFiles::answerOutside()
{
    using Answer = ProjectQuestions::Outside;
    const Answer answer = m_questions.askAboutOutside(displayName());
    return answer == Answer::Replace ? saveTo(path(), Changed::Replace) : answer == Answer::SaveAs && saveAs();
}

void ProjectFiles::tellOfOutside(const FileStamp& now)
{
    if (m_saving)
        return;
    if (m_file.stamp().wholeName.isEmpty()) { // The first that is known of it, but for what a journal tells.
        FileStamp known = stampBefore();
        if (known.exists && now.exists)
            known.wholeName = now.wholeName;
        else
            known = now;
        m_file.set(path(), known);
    }
    QString text;
    if (isGone(m_file.stamp(), now))
        text = tr("'%1' is no longer where it was; saving writes it again.").arg(displayName());
    else if (isChanged(m_file.stamp(), now))
        text = tr("'%1' was changed by another program; saving asks before it replaces that.").arg(displayName());
    if (std::exchange(m_toldOfOutside, text) != text && !text.isEmpty())
        Q_EMIT changedOutside(text);
}

bool ProjectFiles::openPath(const QString& path)
{
    if (!mayOpenTwice(path) || !mayDiscard())
        return false;
    const auto encoded = model::makeEncodedLayers();
    const Taken taken = take(openingOf(path), encoded, path, [path, encoded](const model::Progress& progress) {
        return model::loadProject(path, encoded.get(), progress);
    });
    if (!taken.problem)
        return taken.isOpen;
    m_settings.removeRecentFile(QFileInfo(path).absoluteFilePath());
    if (taken.problem->isDamage)
        return m_questions.offerRepair(taken.problem->message) && openRepaired(path);
    m_questions.complain(taken.problem->message);
    return false;
}

Doing ProjectFiles::restoring()
{
    return {.text = tr("Restoring unsaved work"),
            .whenCancelled = tr("The unsaved work was not restored: cancelled; the next start offers it again")};
}

bool ProjectFiles::restore(const model::RecoveredWork& work)
{
    const model::JournalState& state = work.steps.at(work.current);
    const Doing doing = restoring();
    Q_EMIT openingBegan(doing.text);
    std::optional<model::Result<model::ResolvedMaps>> maps = m_jobs.await<model::ResolvedMaps>(
        doing, [&state](const model::Progress&) -> model::Result<model::ResolvedMaps> {
            return model::ResolvedMaps(state.project);
        });
    if (!maps || !*maps) {
        Q_EMIT openingEnded(false);
        if (maps)
            m_questions.complain(maps->error().message);
        return false;
    }
    m_encoded = model::makeEncodedLayers();
    m_session.document().restore(work, std::move(**maps));
    setPath(state.path);
    m_asRestored = state.file;
    Q_EMIT openingEnded(true);
    return true;
}

FileStamp ProjectFiles::stampBefore() const
{
    if (!m_file.stamp().wholeName.isEmpty() || m_asRestored.bytes < 0)
        return m_file.stamp();
    return {.wholeName = path(), .exists = true, .size = m_asRestored.bytes, .modifiedMs = m_asRestored.timeMs};
}

model::KnownFile ProjectFiles::knownFile() const
{
    const FileStamp& stamp = m_file.stamp();
    return stamp.exists ? model::KnownFile{.bytes = stamp.size, .timeMs = stamp.modifiedMs} : m_asRestored;
}

bool ProjectFiles::openRepaired(const QString& path)
{
    struct Ready
    {
        model::RepairedProject repaired;
        model::ResolvedMaps maps;
    };
    const QString name = QFileInfo(path).fileName();
    const Doing doing{.text = tr("Repairing %1").arg(name),
                      .whenCancelled = tr("The project '%1' was not opened: cancelled").arg(name)};
    Q_EMIT openingBegan(doing.text);
    Awaited<Ready> ready =
        m_jobs.awaitOrLeave<Ready>(doing, [path](const model::Progress& progress) -> model::Result<Ready> {
            model::Result<model::RepairedProject> repaired = model::repairProject(path, progress);
            if (!repaired)
                return tl::unexpected(repaired.error());
            model::ResolvedMaps maps(repaired->project);
            return Ready{.repaired = std::move(*repaired), .maps = std::move(maps)};
        });
    if (ready.end != WorkEnd::Done || !*ready.result)
        Q_EMIT openingEnded(false);
    if (ready.end == WorkEnd::Cancelled)
        return false;
    if (ready.end == WorkEnd::Left || !*ready.result) {
        m_questions.complain(ready.end == WorkEnd::Left ? model::cannotOpen(path, model::silentDisk()).value().message
                                                        : ready.result->error().message);
        return false;
    }
    model::RepairedProject& repaired = (*ready.result)->repaired;
    m_encoded = model::makeEncodedLayers();
    model::RecoveredWork work;
    work.steps.emplace_back().project = std::move(repaired.project);
    m_session.document().restore(work, std::move((*ready.result)->maps));
    m_settings.setLastFolder(QFileInfo(path).absolutePath());
    setPath({}, tr("%1 (repaired)").arg(QFileInfo(path).completeBaseName()));
    Q_EMIT openingEnded(true);
    RepairDialog(path, repaired.losses, &m_window).exec();
    return true;
}

bool ProjectFiles::save()
{
    if (path().isEmpty())
        return saveAs();
    return saveTo(path(), Changed::Ask);
}

bool ProjectFiles::saveAs()
{
    return saveUnder(path().isEmpty()
                         ? m_settings.lastFolder() + QLatin1Char('/') + displayName() + QStringLiteral(".hairpaint")
                         : path());
}

bool ProjectFiles::saveUnder(const QString& suggested)
{
    const QString path = FileDialogs(m_window, m_jobs)
                             .askSavePath({.title = tr("Save project"),
                                           .suggestedPath = suggested,
                                           .filter = tr("Hair Paint projects (*.hairpaint)"),
                                           .suffix = QStringLiteral("hairpaint")});
    return !path.isEmpty() && saveTo(path, Changed::Replace); // Which the dialog has asked about.
}

bool ProjectFiles::saveElsewhere(const QString& path)
{
    // A dialog that began in the folder would wait for it too.
    return m_questions.offerAnotherPath(model::cannotWrite(path, model::silentDisk()).value().message) &&
           saveUnder(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) + QLatin1Char('/') +
                     QFileInfo(path).fileName());
}

bool ProjectFiles::mayDiscard()
{
    m_session.document().settle();
    if (!m_session.document().modified())
        return true;
    using Answer = ProjectQuestions::Unsaved;
    const Answer answer = m_questions.askAboutUnsaved(displayName());
    return answer == Answer::Save ? save() : answer == Answer::Discard;
}

bool ProjectFiles::isLeft(const QString& path) const
{
    return std::ranges::any_of(m_left,
                               [&path](const auto& left) { return left.first == path && !left.second.expired(); });
}

Work<ProjectFiles::Saved> ProjectFiles::savingOf(const QString& path, Changed changed)
{
    // A copy shares tiles, so it is cheap, and the document may go on meanwhile.
    return [path, before = changed == Changed::Ask ? stampBefore() : FileStamp(),
            picture = m_thumbnail ? m_thumbnail() : Picture(), project = m_session.document().committed(),
            keepsEarlier = m_settings.preferences().earlierVersions,
            encoded = m_encoded](const model::Progress& progress) -> model::Result<Saved> {
        if (isChanged(before, stampOf(path)))
            return Saved{.stamp = {}, .wasChanged = true};
        const QImage thumbnail =
            picture ? picture([&](double drawn) { return progress(drawn * kThumbnailFraction); }) : QImage();
        if (!progress(kThumbnailFraction))
            return model::cancelled(path); // Before earlier versions make room for one that does not come.
        if (keepsEarlier)
            if (const model::Checked<void> kept = model::keepEarlierVersions(path); !kept)
                return model::cannotWrite(model::earlierVersion(path, 1), kept.error());
        const model::Result<void> saved =
            model::saveProject(project, path, thumbnail, encoded.get(), [&](double written) {
                return progress(kThumbnailFraction + written * (1.0 - kThumbnailFraction));
            });
        if (!saved)
            return tl::unexpected(saved.error());
        return Saved{.stamp = stampOf(path)};
    };
}

bool ProjectFiles::saveTo(const QString& path, Changed changed)
{
    if (isLeft(path))
        return saveElsewhere(path);
    // The picture is to show what is saved.
    const std::shared_ptr<const void> whole = m_session.wholeHair();
    const QString name = QFileInfo(path).fileName();
    const Doing saving{.text = tr("Saving %1").arg(name),
                       .whenCancelled = tr("The project '%1' was not saved: cancelled").arg(name)};
    const bool came = m_jobs.awaitUntil(saving, [this] {
        m_session.endPreviews(); // Also those that come late.
        return m_session.hair() != Session::Hair::Underway;
    });
    if (!came)
        return false;
    model::Document& document = m_session.document();
    const QUndoCommand* newest = newestStep(document);
    const auto underWay = std::make_shared<const bool>(true);
    Awaited<Saved> saved = [&] {
        const QScopedValueRollback saves(m_saving, true);
        return m_jobs.awaitOrLeave<Saved>(
            saving,
            [work = savingOf(path, changed), underWay](const model::Progress& progress) { return work(progress); },
            Late::Used); // What was written in spite of Cancel is there.
    }();
    if (saved.end == WorkEnd::Left) {
        m_left.emplace_back(path, underWay);
        m_encoded = model::makeEncodedLayers(); // It may still use the other.
        return saveElsewhere(path);
    }
    if (!*saved.result)
        return saved.end != WorkEnd::Cancelled && m_questions.offerAnotherPath(saved.result->error().message) &&
               saveAs();
    if ((*saved.result)->wasChanged)
        return answerOutside();
    // A number that was being typed may have become a step meanwhile, which the file does not hold.
    if (newestStep(document) == newest)
        document.markSaved();
    setPath(path, {}, (*saved.result)->stamp);
    return true;
}

} // namespace hairpaint::app
