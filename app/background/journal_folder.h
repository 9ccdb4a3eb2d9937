// A folder for each open window's journal, locked while the window lives.
#pragma once

#include <QLockFile>
#include <QString>

#include <memory>
#include <vector>

namespace hairpaint::app {

/// The lock names the process, so that it frees itself when that dies, whatever the clock says; nobody else's folder is
/// ever touched. One thread at a time.
class JournalFolder
{
public:
    /// Where the folders of this user lie.
    [[nodiscard]] static QString root();
    /// A new one; null where nothing can be written there.
    [[nodiscard]] static std::unique_ptr<JournalFolder> create(const QString& root);
    /// Those whose windows are gone without having removed them; from now on they are this process's. The one that was
    /// written last comes first.
    [[nodiscard]] static std::vector<std::unique_ptr<JournalFolder>> abandoned(const QString& root);

    /// Of the journal.
    [[nodiscard]] QString file() const;
    /// With everything in it.
    void remove();

private:
    explicit JournalFolder(const QString& path);

    QString m_path;
    QLockFile m_lock;
};

} // namespace hairpaint::app
