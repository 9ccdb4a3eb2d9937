// Names of staged files, and the lock that shows that a process still writes them.
// Any thread. Errors: none.
#pragma once

#include <QFile>

namespace hairpaint::model {

inline constexpr int kStagedNameTries = 16; ///< At a name that is not taken yet.

/// A new name in that folder: hidden, and short enough wherever the file's own name is.
[[nodiscard]] QString stagedNameIn(const QString& folder);
/// Patterns for QDir name filters.
[[nodiscard]] QString stagedNamePattern();

/// Locks the file until it is closed, also by a kill. See OwnFolder::isHeld().
void holdStaged(const QFile& file);

} // namespace hairpaint::model
