// A file being written beside the one that it will replace.
#pragma once

#include <QFile>

namespace hairpaint::model {

/// Has no name until it is whole where the system knows such files, else one that no user gives; either is gone with
/// the object. What a process that was killed leaves is found by that name and by the lock it no longer holds. One
/// thread.
class StagedFile
{
public:
    /// `path`: the file to be, no link (output_path.h).
    explicit StagedFile(const QString& path);
    ~StagedFile();
    StagedFile(const StagedFile&) = delete;
    StagedFile& operator=(const StagedFile&) = delete;

    /// For writing, unbuffered, with the permissions of the file to be, where there is one. False: file() tells why.
    [[nodiscard]] bool open();
    [[nodiscard]] QFile& file() { return m_file; }
    /// Renames it over the target atomically, and closes it. False: nothing has changed; problem() tells why, as a
    /// clause.
    [[nodiscard]] bool publish();
    [[nodiscard]] const QString& problem() const { return m_problem; }

private:
    [[nodiscard]] bool openNameless();
    [[nodiscard]] bool nameIt();

    QString m_path;
    QFile m_file;
    QString m_stagedName; ///< Its path beside m_path while it has one.
    QString m_problem;
};

} // namespace hairpaint::model
