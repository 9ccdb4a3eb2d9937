// The sentences with which reading and writing files fails: each names the file and the way on.
#pragma once

#include "model/error.h"

namespace hairpaint::model {

/// The path as it stands in a sentence: native separators, on one line.
[[nodiscard]] QString shownPath(const QString& path);

/// Inner functions fail with a clause ("the archive is cut short"); these make it a sentence.
[[nodiscard]] tl::unexpected<Error> damaged(const QString& path, const QString& clause);
[[nodiscard]] tl::unexpected<Error> cannotOpen(const QString& path, const QString& clause);
[[nodiscard]] tl::unexpected<Error> cannotWrite(const QString& path, const QString& clause);
[[nodiscard]] tl::unexpected<Error> cancelled(const QString& path);

/// Opens failures that need no reading: missing, a folder, unreadable, empty, larger than `mostBytes`.
[[nodiscard]] Result<void> checkReadable(const QString& path, qint64 mostBytes);

} // namespace hairpaint::model
