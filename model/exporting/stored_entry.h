// A ZIP archive with one file in it, written as it is made.
#pragma once

#include "model/disk/atomic_file.h"
#include "model/files/zip_records.h"

#include <string_view>

namespace hairpaint::model {

/// Stored, not packed, its bytes aligned to 64 as USDZ wants; the time is that of 1980, so that the same content gives
/// the same bytes. One thread.
class StoredEntry
{
public:
    /// `name`: ASCII. The file is open and empty.
    StoredEntry(AtomicFile& file, const QByteArray& name);

    void write(std::string_view bytes);
    /// The archive's directory, and the entry's size and checksum in its head. Refuses what is too large for a ZIP
    /// archive of the common kind.
    [[nodiscard]] Checked<void> finish();

private:
    AtomicFile& m_file;
    ZipRecord m_record;
    qint64 m_bytes = 0;
};

} // namespace hairpaint::model
