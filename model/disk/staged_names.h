// What files under way are called, and how it is told that somebody still writes them.
// Any thread. Errors: none.
#pragma once

#include <QFile>

namespace hairpaint::model {

inline constexpr int kStagedNameTries = 16; ///< At a name that is not taken yet.

/// A new one in that folder: short, so that it has room wherever a file's own name has, and hidden.
[[nodiscard]] QString stagedNameIn(const QString& folder);
/// As QDir filters by.
[[nodiscard]] QString stagedNamePattern();

/// Held until the file is closed, also by a kill; OwnFolder::isHeld() tells.
void holdStaged(const QFile& file);

} // namespace hairpaint::model
