// What is left of a damaged archive of hairpaint_format.md: entries are looked for by their headers, wherever they lie,
// and by what the directory says, and the two may disagree.
#pragma once

#include "model/values/sentences.h"

#include <QByteArray>
#include <QFile>
#include <QStringList>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace hairpaint::model {

/// Only reads the file. One thread at a time.
class SalvagedArchive
{
public:
    /// Looks through the whole file. `goesOn`, asked now and then, may stop it: then what was found by then is there.
    [[nodiscard]] static Checked<SalvagedArchive> open(const QString& path, const std::function<bool()>& goesOn);

    [[nodiscard]] QStringList names() const;

    struct Content
    {
        QByteArray bytes;
        bool whole = false; ///< Whether size and checksum are those in a header; else bytes may be missing or wrong.
    };
    /// The content of an entry, at most `mostBytes`; none where no entry of that name was found.
    [[nodiscard]] std::optional<Content> read(const QString& name, qint64 mostBytes);

private:
    /// What one header says of an entry.
    struct Record
    {
        qint64 at = 0; ///< Offset of the entry's packed bytes in the file.
        qint64 packedBytes = 0;
        qint64 bytes = 0;
        quint32 checksum = 0;
        bool deflated = false;
        int witnesses = 1; ///< Headers that give this offset for an entry of that name.
    };
    [[nodiscard]] Checked<void> findHeaders(const std::function<bool()>& goesOn);
    void readLocal(qint64 at);
    void readCentral(qint64 at);
    void add(const QByteArray& name, const Record& record);
    [[nodiscard]] QByteArray bytesAt(qint64 at, qint64 count);
    /// Offset of the next header after `at`, or of the file's end.
    [[nodiscard]] qint64 endOf(qint64 at) const;
    [[nodiscard]] Content contentOf(const Record& record, qint64 mostBytes);

    std::unique_ptr<QFile> m_file;
    std::vector<qint64> m_headers; ///< Offsets, ascending.
    std::map<QString, std::vector<Record>> m_entries;
};

} // namespace hairpaint::model
