// Where a file that is to be written comes to lie.
#pragma once

#include "model/values/sentences.h"

namespace hairpaint::model {

/// Behind all links, also those that lead to nothing yet, so that it is never a link that is replaced. Clauses for
/// cannotWrite: where that is a folder, a device, a pipe, a socket or a file without a name (replacing one by renaming
/// would do away with it), where links lead round in a circle, and where there is no folder for it. Asks the disk.
[[nodiscard]] Checked<QString> outputPlace(const QString& path);

/// The same, where only the refusal is wanted.
[[nodiscard]] Checked<void> checkWritable(const QString& path);

} // namespace hairpaint::model
