// What a ZIP archive says of its entries (PKWARE's APPNOTE, sections 4.3.7, 4.3.12 and 4.3.16): an archive of the
// common kind, below 4 GB, without ZIP64.
#pragma once

#include <QByteArray>
#include <QByteArrayView>

#include <limits>

namespace hairpaint::model {

inline constexpr qint64 kMostZipBytes = std::numeric_limits<quint32>::max();

/// Its time is that of 1980, so that the same content gives the same bytes.
struct ZipRecord
{
    QByteArray name;    ///< ASCII.
    QByteArray padding; ///< An extra field, before the bytes only.
    bool isDeflated = false;
    quint32 checksum = 0; ///< CRC-32 of the bytes before they are packed.
    quint32 packedBytes = 0;
    quint32 bytes = 0;
    quint32 at = 0; ///< Where its local header stands in the file.
};

/// Stands before the entry's bytes.
[[nodiscard]] QByteArray localHeader(const ZipRecord& record);
/// Stands in the directory, behind all entries.
[[nodiscard]] QByteArray directoryHeader(const ZipRecord& record);
/// Ends the file; the directory stands before it.
[[nodiscard]] QByteArray endOfDirectory(int entries, qsizetype directoryBytes, qint64 directoryAt);

/// CRC-32, on from that of the bytes before these.
[[nodiscard]] quint32 checksumOf(QByteArrayView bytes, quint32 before = 0);

} // namespace hairpaint::model
