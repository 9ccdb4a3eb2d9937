// Reads what a journal's writer left.
#pragma once

#include "model/disk/own_folder.h"
#include "model/document/journal_state.h"
#include "model/project/content_budget.h"
#include "model/values/progress.h"
#include "model/values/sentences.h"

#include <optional>

namespace hairpaint::model {

/// Limit on the bytes of the recovered steps together: as much as one content may hold, and a quarter more for the
/// tiles in which the other steps differ.
inline constexpr std::size_t kMostRecoveredBytes = kMostHeldBytes + kMostHeldBytes / 4;

/// The steps of the undo history to which the journal's last whole state belongs. None where nothing was appended since
/// the project was saved, and for a file of another version. A file that is cut off or damaged gives the states before
/// that byte. Where the steps need more than `mostBytes`, those far from the last one are left out. Only an ordinary
/// file is read, not one behind a link. Any thread. A cancelled or unreadable one gives an error.
[[nodiscard]] Result<std::optional<RecoveredWork>> readJournal(const OwnFolder& folder, const QString& name,
                                                               const Progress& progress = {},
                                                               std::size_t mostBytes = kMostRecoveredBytes);
[[nodiscard]] Result<std::optional<RecoveredWork>> readJournal(const QString& path, const Progress& progress = {});

} // namespace hairpaint::model
