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

    /// Fails if nothing can be written there; call it first. `path`: the target that the sentence
    /// names.
    [[nodiscard]] Result<void> check(const QString& path) const;
    /// The path of the staged file for that target. Its name has a suffix.
    [[nodiscard]] QString pathFor(const QString& path);
    /// The error with the path of the target instead of that of the staged file.
    [[nodiscard]] Error named(Error error, const QString& path) const;
    /// Moves all files over their targets (links resolved). If one cannot be moved, none is.
    [[nodiscard]] Result<void> publish(const QStringList& wanted);

private:
    [[nodiscard]] bool makeFolder(const QString& path);
    [[nodiscard]] QString stagedPath(const QString& name) const;
    /// The path to which the target's former file is moved meanwhile.
    [[nodiscard]] QString asideFor(qsizetype number) const;

    QString m_folder; ///< Empty where none could be made.
    QFile m_lock;
    QString m_problem;   ///< Why nothing can be staged, as a clause.
    QStringList m_names; ///< Names of files that may lie in the folder; listing it on the way out would need memory.
    qsizetype m_asideCount = 0;
};

} // namespace hairpaint::model
