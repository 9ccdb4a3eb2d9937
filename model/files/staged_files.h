// Several files that take their places together, once the last of them is whole.
#pragma once

#include "model/error.h"

#include <QStringList>
#include <QTemporaryDir>

namespace hairpaint::model {

/// A folder beside those places, which goes with it. One thread.
class StagedFiles
{
public:
    /// `folder`: that of the places.
    explicit StagedFiles(const QString& folder);

    /// Fails where nothing can be put there; to be asked before the rest. `place`: what the sentence names.
    [[nodiscard]] Result<void> check(const QString& place) const;
    /// Where the file of that place lies meanwhile.
    [[nodiscard]] QString pathFor(const QString& place) const;
    /// The error with the place named, not where the file lay meanwhile.
    [[nodiscard]] Error named(Error error, const QString& place) const;
    /// Moves all files over what lies in their places, or, where one can't be, none.
    [[nodiscard]] Result<void> publish(const QStringList& places) const;

private:
    /// Where the file that lay in that place is meanwhile.
    [[nodiscard]] QString asideFor(qsizetype number) const;

    QTemporaryDir m_folder;
};

} // namespace hairpaint::model
