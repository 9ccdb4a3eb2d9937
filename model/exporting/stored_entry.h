// A ZIP archive with one file in it, written as it is made.
#pragma once

#include "model/files/atomic_file.h"

#include <string>
#include <string_view>

namespace hairpaint::model {

/// Stored, not packed, its bytes aligned to 64 as USDZ wants; the time is that of 1980, so that the same content gives
/// the same bytes. One thread.
class StoredEntry
{
public:
    /// `name`: ASCII. The file is open and empty.
    StoredEntry(AtomicFile& file, std::string name);

    void write(std::string_view bytes);
    /// The archive's directory, and the entry's size and checksum in its head. Refuses what is too large for a ZIP
    /// archive of the common kind.
    [[nodiscard]] Checked<void> finish();

private:
    [[nodiscard]] std::string commonFields() const;

    AtomicFile& m_file;
    std::string m_name;
    std::string m_padding; ///< An extra field that moves the bytes to a multiple of 64.
    quint64 m_size = 0;
    quint32 m_checksum = 0;
};

} // namespace hairpaint::model
