// Reads what a journal's writer left.
#pragma once

#include "model/document/journal_state.h"
#include "model/values/progress.h"
#include "model/values/sentences.h"

#include <optional>

namespace hairpaint::model {

/// The steps of the history that the journal's last whole state is one of. None where nothing was appended since the
/// project was saved, and for a file of another version. A file that ends anywhere, or is damaged from some place on,
/// gives what stands before that place. Any thread; a cancelled or unreadable one gives an error.
[[nodiscard]] Result<std::optional<RecoveredWork>> readJournal(const QString& path, const Progress& progress = {});

} // namespace hairpaint::model
