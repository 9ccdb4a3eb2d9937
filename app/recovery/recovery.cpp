// Reading journals and asking.
#include "app/recovery/recovery.h"

#include "app/recovery/recovery_dialog.h"
#include "app/styles/style_pictures.h"
#include "model/disk/staged_sweep.h"
#include "model/journal/journal_reader.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QSet>

#include <thread>

namespace hairpaint::app {

namespace {

struct Recovery
{
    Q_DECLARE_TR_FUNCTIONS(Recovery)
};

UnsavedWork offerOf(const model::RecoveredWork& work)
{
    const model::JournalState& state = work.steps[work.current];
    return {.name = state.path.isEmpty() ? Recovery::tr("Untitled") : QFileInfo(state.path).completeBaseName(),
            .path = state.path,
            .changed = QDateTime::fromMSecsSinceEpoch(state.timeMs),
            .steps = static_cast<int>(work.current)};
}

/// None where it was cancelled.
std::optional<std::vector<RestoredWork>> readJournals(const QString& root, Jobs& jobs)
{
    std::vector<RestoredWork> found;
    for (std::unique_ptr<JournalFolder>& folder : JournalFolder::abandoned(root)) {
        using Read = std::optional<model::RecoveredWork>;
        const QString file = folder->file();
        std::optional<model::Result<Read>> read =
            jobs.await<Read>({.text = Recovery::tr("Looking for unsaved work"),
                              .whenCancelled = Recovery::tr("Unsaved work was not looked for: cancelled; the next "
                                                            "start looks again")},
                             [&file](const model::Progress& progress) { return model::readJournal(file, progress); });
        if (!read)
            return std::nullopt; // They are there at the next start.
        if (*read && !**read)
            folder->remove(); // All of it was saved.
        else if (*read)
            found.push_back({.work = std::move(***read), .folder = std::move(folder)});
    }
    return found;
}

} // namespace

UnsavedAnswer askForUnsavedWork(const QString& root, Jobs& jobs, QWidget& window)
{
    std::optional<std::vector<RestoredWork>> read = readJournals(root, jobs);
    if (!read)
        return {.restored = std::nullopt, .isKept = true};
    std::vector<RestoredWork>& found = *read;
    if (found.empty())
        return {};
    std::vector<UnsavedWork> offers;
    offers.reserve(found.size());
    for (const RestoredWork& one : found)
        offers.push_back(offerOf(one.work));
    RecoveryDialog dialog(
        offers, [&found](std::size_t index) { found[index].folder->remove(); }, &window);
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
        return {.restored = std::nullopt, .isKept = isKept};
    return {.restored = std::move(found[dialog.chosen()]), .isKept = isKept};
}

void sweepBeside(const QStringList& files)
{
    QSet<QString> folders;
    for (const QString& file : files)
        folders.insert(QFileInfo(file).absolutePath());
    std::thread([folders] {
        for (const QString& folder : folders)
            (void)model::sweepStaged(folder);
    }).detach();
}

} // namespace hairpaint::app
