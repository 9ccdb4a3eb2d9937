// The path of a file to be written, with links resolved.
#pragma once

#include "model/values/sentences.h"

namespace hairpaint::model {

/// Resolves all links, also dangling ones, so that a link is never replaced by a file. Errors, as clauses for
/// cannotWrite: the target is a folder, a device, a pipe, a socket or a file without a name (replacing one by renaming
/// would delete it); the links form a cycle; the folder does not exist. Reads the disk.
[[nodiscard]] Checked<QString> outputPath(const QString& path);

/// The same check, without the path.
[[nodiscard]] Checked<void> checkWritable(const QString& path);

} // namespace hairpaint::model
