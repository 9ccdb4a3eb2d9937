// Several files that replace their targets together, once the last of them is whole.
#pragma once

#include "model/values/error.h"

#include <QFile>
#include <QStringList>

namespace hairpaint::model {

/// A hidden folder beside the targets, which goes with it; what a process that was killed leaves is told from one in
/// use by a lock in it (staged_sweep.h). One thread.
class StagedFiles
{
public:
    static constexpr QLatin1StringView kLockName{"lock"};
    static constexpr QLatin1StringView kAsideName{"before"}; ///< A folder of the files that are replaced.

    /// `folder`: that of the targets. What others have left there is swept.
    explicit StagedFiles(const QString& folder);
    ~StagedFiles();
    StagedFiles(const StagedFiles&) = delete;
    StagedFiles& operator=(const StagedFiles&) = delete;

    /// Fails where nothing can be written there; to be asked before the rest. `place`: the target that the sentence
    /// names.
    [[nodiscard]] Result<void> check(const QString& place) const;
    /// Where the file for that target lies meanwhile. Its name has a suffix.
    [[nodiscard]] QString pathFor(const QString& place);
    /// The error with the target named, not where the file lay meanwhile.
    [[nodiscard]] Error named(Error error, const QString& place) const;
    /// Moves all files over their targets, or over what those are links to, or, where one can't be, none.
    [[nodiscard]] Result<void> publish(const QStringList& wanted);

private:
    [[nodiscard]] bool makeFolder(const QString& path);
    [[nodiscard]] QString stagedPath(const QString& name) const;
    /// Where the target's former file is meanwhile.
    [[nodiscard]] QString asideFor(qsizetype number) const;

    QString m_folder; ///< Empty where none could be made.
    QFile m_lock;
    QString m_problem;   ///< Why nothing can be staged, as a clause.
    QStringList m_names; ///< Of files that may lie in it: to find them by listing would need memory.
    qsizetype m_asideCount = 0;
};

} // namespace hairpaint::model
