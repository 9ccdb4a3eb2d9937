// Work in folders of the program's own, and on names of its own in the user's: no link is ever followed there.
#pragma once

#include <QFile>
#include <QString>
#include <QStringList>

#include <optional>

namespace hairpaint::model {

/// An entry of a folder. A link is reported as the link, not as its target.
struct OwnEntry
{
    enum class Kind
    {
        File,
        Folder,
        Other ///< A link, a device, a pipe.
    };
    Kind kind = Kind::Other;
    qint64 size = 0;
    qint64 modifiedMs = 0;      ///< Since 1970, UTC.
    bool hasOtherNames = false; ///< A file that lies elsewhere too.
};

/// A folder held open, so that every operation acts on that folder even if its path refers to another one by then.
/// Names are those of its entries, without a slash. Never blocks on a pipe or a device. Outside Unix, the kind of an
/// entry is checked just before it is used. Any thread, one at a time.
class OwnFolder
{
public:
    /// Links that lead there are followed: whoever owns the folder has laid them. None where there is no such folder.
    [[nodiscard]] static std::optional<OwnFolder> open(const QString& path);
    /// A subfolder; none if the name is anything else, such as a link to a folder.
    [[nodiscard]] std::optional<OwnFolder> child(const QString& name) const;

    OwnFolder(OwnFolder&& other) noexcept;
    OwnFolder& operator=(OwnFolder&& other) noexcept;
    OwnFolder(const OwnFolder&) = delete;
    OwnFolder& operator=(const OwnFolder&) = delete;
    ~OwnFolder();

    [[nodiscard]] const QString& path() const { return m_path; }
    [[nodiscard]] QString pathOf(const QString& name) const { return m_path + QLatin1Char('/') + name; }
    /// Whether its path still refers to it.
    [[nodiscard]] bool isAtPath() const;
    /// The names of all entries.
    [[nodiscard]] QStringList names() const;
    [[nodiscard]] std::optional<OwnEntry> entry(const QString& name) const;
    /// Whether the open file is the entry of that name.
    [[nodiscard]] bool isNamed(const QFile& file, const QString& name) const;

    /// Opens a regular file for reading. False: problem() tells why.
    [[nodiscard]] bool openToRead(QFile& file, const QString& name) const;
    /// A new and empty file for writing, unbuffered, that its owner alone may read; an entry of
    /// that name is removed, unless it is a folder.
    [[nodiscard]] bool openNew(QFile& file, const QString& name) const;
    /// Why the last openToRead() or openNew() failed, as a clause.
    [[nodiscard]] const QString& problem() const { return m_problem; }

    /// Creates a folder that only its owner may read.
    [[nodiscard]] bool makeFolder(const QString& name) const;
    /// Renames an entry; one with the new name is replaced.
    [[nodiscard]] bool rename(const QString& from, const QString& to) const;
    bool remove(const QString& name) const;       ///< Anything but a folder.
    bool removeFolder(const QString& name) const; ///< Only an empty folder.
    /// Flushes the folder, so that new names survive a power cut. Not every file system supports it.
    void flush() const;
    /// Whether a process holds the file by holdStaged(); also true if that is unknown. Always false outside Unix.
    [[nodiscard]] bool isHeld(const QString& name) const;

    /// On Unix the folder's descriptor, else -1.
    [[nodiscard]] int descriptor() const { return m_descriptor; }

private:
    OwnFolder(QString path, int descriptor);

    QString m_path;
    int m_descriptor = -1;
    mutable QString m_problem;
};

/// Reads a regular file of at most that many bytes. Links to it are followed; never blocks on a pipe or a device.
/// None if it is missing or not a regular file. Any thread.
[[nodiscard]] std::optional<QByteArray> contentOfOrdinaryFile(const QString& path, qint64 mostBytes);

} // namespace hairpaint::model
