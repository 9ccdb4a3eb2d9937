// At the start: offers the unsaved work of windows that ended without saving.
#pragma once

#include "app/background/jobs.h"
#include "app/background/journal_folder.h"
#include "model/document/journal_state.h"

#include <optional>

namespace hairpaint::app {

struct RestoredWork
{
    model::RecoveredWork work;
    std::unique_ptr<JournalFolder> folder;
};
struct UnsavedAnswer
{
    std::optional<RestoredWork> restored;
    bool isKept = false; ///< Some of it was neither restored nor discarded: it is for the next start.
    QString problem;     ///< Why some of it could not be offered, as a sentence; mostly empty.
};
/// Looks for journals of windows that are gone and asks; those of the file `first` are offered first. What is to be
/// restored comes back, with its folder, which is removed only once the work is in another journal or a file. Journals
/// that lie where nothing can be written are offered too. GUI thread, which waits for no disk.
[[nodiscard]] UnsavedAnswer askForUnsavedWork(const QString& root, Jobs& jobs, QWidget& window,
                                              const QString& first = {});

/// Removes what saves that were killed have left beside `files`; on a thread of its own, since a folder of the network
/// may keep it waiting.
void sweepBeside(const QStringList& files);

} // namespace hairpaint::app
