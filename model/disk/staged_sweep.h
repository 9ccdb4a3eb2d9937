// What processes that were killed have left beside the files that they wrote.
#pragma once

#include <QString>

namespace hairpaint::model {

/// Removes files and folders of StagedFile and StagedFiles in that folder, none that anyone still writes, and nothing
/// that were moved aside and not moved back. How many. Any thread.
int sweepStaged(const QString& folder);

} // namespace hairpaint::model
