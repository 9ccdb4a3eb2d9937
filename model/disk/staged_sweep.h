// Removes what killed processes left beside the files that they wrote.
#pragma once

#include <QString>

namespace hairpaint::model {

/// Removes files and folders of StagedFile and StagedFiles in that folder, except those still being written and
/// former files that were moved aside and not moved back. Returns how many. Any thread.
int sweepStaged(const QString& folder);

} // namespace hairpaint::model
