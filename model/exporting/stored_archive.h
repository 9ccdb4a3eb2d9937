// A ZIP archive of files that are not packed, written as they are made.
#pragma once

#include "model/disk/atomic_file.h"
#include "model/files/zip_records.h"

#include <string_view>
#include <vector>

namespace hairpaint::model {

/// Entries lie one after another, their bytes aligned to 64 as USDZ wants; the time is that of 1980, so that the same
/// content gives the same bytes. One thread.
class StoredArchive
{
public:
    explicit StoredArchive(AtomicFile& file) : m_file(file) {} ///< Open and empty.

    void begin(const QByteArray& name); ///< Ends the entry before. `name`: ASCII.
    void write(std::string_view bytes); ///< On with the entry that was begun.
    /// The archive's directory, and the entries' sizes and checksums in their heads. Refuses what is too large for a
    /// ZIP archive of the common kind.
    [[nodiscard]] Checked<void> finish();

private:
    AtomicFile& m_file;
    std::vector<ZipRecord> m_records;
    std::vector<qint64> m_sizes; ///< By record.
    std::vector<qint64> m_at;    ///< By record: where its head stands.
    qint64 m_end = 0;
};

} // namespace hairpaint::model
