// Several files that take their places together, once the last of them is whole.
#pragma once

#include "model/values/error.h"

#include <QFile>
#include <QStringList>

namespace hairpaint::model {

/// A hidden folder beside those places, which goes with it; what a process that was killed leaves is told from one in
/// use by a lock in it (staged_sweep.h). One thread.
class StagedFiles
{
public:
    static constexpr QLatin1StringView kLockName{"lock"};
    static constexpr QLatin1StringView kAsideName{"before"}; ///< A folder of what lay in the places.

    /// `folder`: that of the places. What others have left there is swept.
    explicit StagedFiles(const QString& folder);
    ~StagedFiles();
    StagedFiles(const StagedFiles&) = delete;
    StagedFiles& operator=(const StagedFiles&) = delete;

    /// Fails where nothing can be put there; to be asked before the rest. `place`: what the sentence names.
    [[nodiscard]] Result<void> check(const QString& place) const;
    /// Where the file of that place lies meanwhile. Its name has a suffix.
    [[nodiscard]] QString pathFor(const QString& place);
    /// The error with the place named, not where the file lay meanwhile.
    [[nodiscard]] Error named(Error error, const QString& place) const;
    /// Moves all files over what lies in their places, or behind the links there, or, where one can't be, none.
    [[nodiscard]] Result<void> publish(const QStringList& wanted);

private:
    [[nodiscard]] bool makeFolder(const QString& path);
    [[nodiscard]] QString stagedPath(const QString& name) const;
    /// Where the file that lay in that place is meanwhile.
    [[nodiscard]] QString asideFor(qsizetype number) const;

    QString m_folder; ///< Empty where none could be made.
    QFile m_lock;
    QString m_problem;   ///< Why not, as a clause.
    QStringList m_names; ///< Of files that may lie in it: to find them by listing would need memory.
    qsizetype m_asideCount = 0;
};

} // namespace hairpaint::model
