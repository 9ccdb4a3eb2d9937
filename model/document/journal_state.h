// The states that a journal stores.
#pragma once

#include "model/project/project.h"

#include <QString>

#include <vector>

namespace hairpaint::model {

/// Size and time of a project's file when this program last read or wrote it.
struct KnownFile
{
    qint64 bytes = -1; ///< The file's size; -1 where it is not known.
    qint64 timeMs = 0; ///< When the file was changed last, ms since 1970, UTC.
};

/// The committed content after one step of the undo history, and where in it that is.
struct JournalState
{
    Project project;
    QString path;        ///< Path of the project's file; empty where the project was never saved.
    KnownFile file = {}; ///< Size and time of the file at `path`.
    QString step;        ///< Text of the undo step that led to this state.
    int index = 0;       ///< Number of steps that undo can take back.
    int count = 0;       ///< Number of steps in the history, undone ones included.
    qint64 timeMs = 0;   ///< When the step was made, ms since 1970, UTC.
};

/// What is read from a journal.
struct RecoveredWork
{
    std::vector<JournalState> steps; ///< Neighbours in the history, oldest first; one at least.
    std::size_t current = 0;         ///< Index into `steps` of the state that was shown last.
};

} // namespace hairpaint::model
