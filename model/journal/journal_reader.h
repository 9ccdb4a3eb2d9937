// Reads what a journal's writer left.
#pragma once

#include "model/files/own_folder.h"
#include "model/files/sentences.h"
#include "model/journal/journal_state.h"
#include "model/progress.h"

#include <optional>

namespace hairpaint::model {

/// The steps of the history that the journal's last whole state is one of. None where nothing was appended since the
/// project was saved, and for a file of another version. A file that ends anywhere, or is damaged from some place on,
/// gives what stands before that place; where it stands for more than a document and its history may hold, the oldest
/// steps are left out. Only an ordinary file is read, not one behind a link. Any thread; a cancelled or unreadable one
/// gives an error.
[[nodiscard]] Result<std::optional<RecoveredWork>> readJournal(const OwnFolder& folder, const QString& name,
                                                               const Progress& progress = {});
[[nodiscard]] Result<std::optional<RecoveredWork>> readJournal(const QString& path, const Progress& progress = {});

} // namespace hairpaint::model
