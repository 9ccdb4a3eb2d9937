// At the start: what other windows left unsaved, and what becomes of it.
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
};
/// Looks for journals of windows that are gone and asks. What is to be restored comes back, with its folder, which is
/// removed only once the work is in another journal or a file. GUI thread.
[[nodiscard]] UnsavedAnswer askForUnsavedWork(const QString& root, Jobs& jobs, QWidget& window);

/// Removes what saves that were killed have left beside `files`; on a thread of its own, since a folder of the network
/// may keep it waiting.
void sweepBeside(const QStringList& files);

} // namespace hairpaint::app
