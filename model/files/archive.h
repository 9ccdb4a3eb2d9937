// ZIP archives as project and preset files use them. Wraps libzip, which reads.
// Errors: clauses for a sentence of sentences.h.
#pragma once

#include "model/values/sentences.h"

#include <QByteArray>
#include <QStringList>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace hairpaint::model {

inline constexpr int kMostArchiveEntries = 8192;

/// Names and sizes are checked when it opens (see the limits in hairpaint_format.md); bytes are read on demand.
/// One thread at a time. Throws std::bad_alloc where memory runs out.
class ArchiveReader
{
public:
    /// The path must be a readable file (checkReadable).
    [[nodiscard]] static Checked<ArchiveReader> open(const QString& path);

    ArchiveReader(ArchiveReader&& other) noexcept;
    ArchiveReader& operator=(ArchiveReader&& other) noexcept;
    ~ArchiveReader();

    [[nodiscard]] bool contains(const QString& name) const { return m_entries.contains(name); }
    [[nodiscard]] QStringList names() const; ///< Names of all entries, in the archive's order.
    enum class Check
    {
        Checksum,
        ByCaller ///< read() skips the checksum; the caller compares it, on any thread, and refuses with brokenEntry().
    };
    /// Refuses an entry that is missing, larger than `mostBytes`, or does not match its checksum.
    [[nodiscard]] Checked<QByteArray> read(const QString& name, qint64 mostBytes, Check check = Check::Checksum) const;
    /// The CRC-32 that the archive gives for an entry; the entry must exist.
    [[nodiscard]] quint32 checksum(const QString& name) const { return m_entries.at(name).crc; }

private:
    struct ListedEntry
    {
        quint64 index = 0;
        quint64 size = 0;
        quint32 crc = 0;
        bool isStored = false;
    };
    struct Handle;
    ArchiveReader();
    Checked<void> readDirectory();

    std::unique_ptr<Handle> m_handle;
    std::map<QString, ListedEntry> m_entries; ///< No QHash, which ends the program where memory runs out.
};

[[nodiscard]] tl::unexpected<Clause> brokenEntry(const QString& name);

/// Collects entries and writes them all at once. The same entries give the same bytes.
class ArchiveWriter
{
public:
    enum class Method
    {
        Stored,
        Deflated
    };
    /// `name`: ASCII; `checksum`: CRC-32 of the bytes, where it is known.
    void add(const QByteArray& name, const QByteArray& bytes, Method method, std::optional<quint32> checksum = {});
    /// Atomic: afterwards `path` holds the archive, or what it held before. Where it `isWanted` no longer when all of
    /// it lies on the disk, nothing is replaced and the answer is false.
    [[nodiscard]] Checked<bool> writeTo(const QString& path, const std::function<bool()>& isWanted = {}) const;

private:
    struct AddedEntry
    {
        QByteArray name;
        QByteArray bytes;
        Method method = Method::Stored;
        std::optional<quint32> checksum;
    };
    std::vector<AddedEntry> m_entries;
};

} // namespace hairpaint::model
