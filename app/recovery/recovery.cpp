// Reading journals and asking.
#include "app/recovery/recovery.h"

#include "app/background/counted_thread.h"
#include "app/recovery/recovery_dialog.h"
#include "app/styles/style_pictures.h"
#include "model/disk/staged_sweep.h"
#include "model/journal/journal_reader.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QSet>

#include <algorithm>

namespace hairpaint::app {

namespace {

struct Recovery
{
    Q_DECLARE_TR_FUNCTIONS(Recovery)
};

UnsavedWork offerOf(const RestoredWork& found)
{
    const model::JournalState& state = found.work.steps[found.work.current];
    return {.name = state.path.isEmpty() ? Recovery::tr("Untitled") : QFileInfo(state.path).completeBaseName(),
            .path = state.path,
            .changed = QDateTime::fromMSecsSinceEpoch(state.timeMs),
            .steps = static_cast<int>(found.work.current),
            .unwritable = found.folder->isLocked() ? QString() : found.folder->own()->path()};
}

struct FoundWork
{
    std::vector<RestoredWork> works;
    QString problem;
};

model::Result<FoundWork> readJournals(const QString& root, const model::Progress& progress)
{
    FoundWork found;
    std::vector<std::unique_ptr<JournalFolder>> folders = JournalFolder::abandoned(root);
    const auto count = static_cast<double>(folders.size());
    for (std::size_t i = 0; i < folders.size(); ++i) {
        std::unique_ptr<JournalFolder>& folder = folders[i];
        model::Result<std::optional<model::RecoveredWork>> read =
            model::readJournal(*folder->own(), JournalFolder::fileName(),
                               [&](double done) { return progress((static_cast<double>(i) + done) / count); });
        if (!progress(static_cast<double>(i + 1) / count))
            return model::cancelled(root); // They are there at the next start.
        if (!read)
            found.problem = read.error().message;
        else if (!*read)
            folder->remove(); // All of it was saved.
        else
            found.works.push_back({.work = std::move(**read), .folder = std::move(folder)});
    }
    return found;
}

} // namespace

UnsavedAnswer askForUnsavedWork(const QString& root, Jobs& jobs, QWidget& window, const QString& first)
{
    Awaited<FoundWork> read = jobs.awaitOrLeave<FoundWork>(
        {.text = Recovery::tr("Looking for unsaved work"),
         .whenCancelled = Recovery::tr("Unsaved work was not looked for: cancelled; the next start looks again")},
        [root](const model::Progress& progress) { return readJournals(root, progress); });
    if (read.end == WorkEnd::Left)
        return {.restored = std::nullopt,
                .isKept = true,
                .problem = model::cannotOpen(root, model::silentDisk()).value().message};
    if (read.end == WorkEnd::Cancelled)
        return {.restored = std::nullopt, .isKept = true, .problem = {}};
    if (!*read.result)
        return {.restored = std::nullopt, .isKept = true, .problem = read.result->error().message};
    std::vector<RestoredWork>& found = (*read.result)->works;
    const QString& problem = (*read.result)->problem;
    if (found.empty())
        return {.restored = std::nullopt, .isKept = false, .problem = problem};
    std::stable_partition(found.begin(), found.end(), [&first](const RestoredWork& one) {
        return !first.isEmpty() && one.work.steps[one.work.current].path == first;
    });
    std::vector<UnsavedWork> offers;
    offers.reserve(found.size());
    for (const RestoredWork& one : found)
        offers.push_back(offerOf(one));
    RecoveryDialog dialog(
        offers, [&found](std::size_t index) { return found[index].folder->remove(); }, &window);
    for (std::size_t i = 0; i < found.size(); ++i) {
        const model::RecoveredWork& work = found[i].work;
        jobs.start<QImage>(
            Recovery::tr("Drawing the picture"),
            [project = work.steps[work.current].project](const model::Progress& progress) -> model::Result<QImage> {
                return projectPicture(project, progress);
            },
            &dialog,
            [&dialog, i](const model::Result<QImage>& picture) {
                if (picture && !picture->isNull())
                    dialog.setPicture(i, *picture);
            });
    }
    const bool isAccepted = dialog.exec() == QDialog::Accepted;
    const bool isKept = dialog.count() > (isAccepted ? 1 : 0);
    if (!isAccepted)
        return {.restored = std::nullopt, .isKept = isKept, .problem = problem};
    return {.restored = std::move(found[dialog.chosen()]), .isKept = isKept, .problem = problem};
}

void sweepBeside(const QStringList& files)
{
    QSet<QString> folders;
    for (const QString& file : files)
        folders.insert(QFileInfo(file).absolutePath());
    countedThread([folders] {
        for (const QString& folder : folders)
            (void)model::sweepStaged(folder);
    }).detach();
}

} // namespace hairpaint::app
