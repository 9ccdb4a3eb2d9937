// Work in folders of the program's own, and on names of its own in the user's: no link is ever followed there.
#pragma once

#include <QFile>
#include <QString>
#include <QStringList>

#include <optional>

namespace hairpaint::model {

/// What has a name in a folder, by itself: of a link, the link.
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

/// A folder that is held open, so that what is done in it is done in that very folder, whatever its path leads to by
/// then. Names are those of its entries, without a slash. Nothing waits for a pipe or a device. Elsewhere than on Unix
/// what a name stands for is looked at just before it is used. Any thread, one at a time.
class OwnFolder
{
public:
    /// Links that lead there are followed: whoever owns the folder has laid them. None where there is no such folder.
    [[nodiscard]] static std::optional<OwnFolder> open(const QString& path);
    /// A folder in this one; none where that name is anything else, a link to a folder too.
    [[nodiscard]] std::optional<OwnFolder> child(const QString& name) const;

    OwnFolder(OwnFolder&& other) noexcept;
    OwnFolder& operator=(OwnFolder&& other) noexcept;
    OwnFolder(const OwnFolder&) = delete;
    OwnFolder& operator=(const OwnFolder&) = delete;
    ~OwnFolder();

    [[nodiscard]] const QString& path() const { return m_path; }
    [[nodiscard]] QString pathOf(const QString& name) const { return m_path + QLatin1Char('/') + name; }
    /// Its path still leads to it.
    [[nodiscard]] bool isInPlace() const;
    /// Of all entries.
    [[nodiscard]] QStringList names() const;
    [[nodiscard]] std::optional<OwnEntry> entry(const QString& name) const;
    /// The open file is what has that name now.
    [[nodiscard]] bool isNamed(const QFile& file, const QString& name) const;

    /// An ordinary file, for reading. False: problem() tells why.
    [[nodiscard]] bool openToRead(QFile& file, const QString& name) const;
    /// A new and empty file for writing, unbuffered, that its owner alone may read; whatever had the name is removed,
    /// but no folder.
    [[nodiscard]] bool openNew(QFile& file, const QString& name) const;
    /// Why the last openToRead() or openNew() failed, as a clause.
    [[nodiscard]] const QString& problem() const { return m_problem; }

    /// That its owner alone may look into.
    [[nodiscard]] bool makeFolder(const QString& name) const;
    /// Over what has the other name.
    [[nodiscard]] bool rename(const QString& from, const QString& to) const;
    bool remove(const QString& name) const;       ///< Anything but a folder.
    bool removeFolder(const QString& name) const; ///< Only an empty folder.
    /// So that new names outlive a power cut; not every file system can.
    void flush() const;
    /// Somebody holds the file by holdStaged(), or it can't be told. Elsewhere than on Unix never.
    [[nodiscard]] bool isHeld(const QString& name) const;

    /// On Unix the folder's descriptor, else -1.
    [[nodiscard]] int descriptor() const { return m_descriptor; }

private:
    OwnFolder(QString path, int descriptor);

    QString m_path;
    int m_descriptor = -1;
    mutable QString m_problem;
};

/// All of an ordinary file of at most that many bytes; links that lead to it are followed, and nothing waits for a pipe
/// or a device. None where it is missing or anything else. Any thread.
[[nodiscard]] std::optional<QByteArray> contentOfOrdinaryFile(const QString& path, qint64 mostBytes);

} // namespace hairpaint::model
