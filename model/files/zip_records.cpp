// Little-endian numbers in their order.
#include "model/files/zip_records.h"

#include <QtEndian>

#include <zlib.h>

namespace hairpaint::model {

namespace {

constexpr quint16 kStoredVersion = 10;
constexpr quint16 kDeflatedVersion = 20;
constexpr quint16 kDeflated = 8;
constexpr quint16 kDate1980 = (1U << 5U) | 1U;

template<typename... Numbers>
void append(QByteArray& out, Numbers... values)
{
    const auto one = [&out](auto value) {
        const auto little = qToLittleEndian(value);
        out.append(reinterpret_cast<const char*>(&little), sizeof(little));
    };
    (one(values), ...);
}

/// What both headers say.
QByteArray commonFields(const ZipRecord& record)
{
    QByteArray fields;
    append(fields, record.isDeflated ? kDeflatedVersion : kStoredVersion, quint16{0}, // No flags.
           record.isDeflated ? kDeflated : quint16{0}, quint16{0},                    // Midnight.
           kDate1980, record.checksum, record.packedBytes, record.bytes, static_cast<quint16>(record.name.size()));
    return fields;
}

} // namespace

QByteArray localHeader(const ZipRecord& record)
{
    QByteArray header("PK\x03\x04", 4);
    header += commonFields(record);
    append(header, static_cast<quint16>(record.padding.size()));
    return header + record.name + record.padding;
}

QByteArray directoryHeader(const ZipRecord& record)
{
    QByteArray header("PK\x01\x02", 4);
    append(header, record.isDeflated ? kDeflatedVersion : kStoredVersion);
    header += commonFields(record);
    append(header, quint16{0}, // No extra field here,
           quint16{0},         // no remark,
           quint16{0},         // on the first disk,
           quint16{0},         // and with attributes
           quint32{0},         // of no system.
           record.at);
    return header + record.name;
}

QByteArray endOfDirectory(int entries, qsizetype directoryBytes, qint64 directoryAt)
{
    QByteArray end("PK\x05\x06", 4);
    append(end, quint32{0}, // One disk.
           static_cast<quint16>(entries), static_cast<quint16>(entries), static_cast<quint32>(directoryBytes),
           static_cast<quint32>(directoryAt), quint16{0}); // No remark.
    return end;
}

quint32 checksumOf(QByteArrayView bytes, quint32 before)
{
    return static_cast<quint32>(
        crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<std::size_t>(bytes.size())));
}

} // namespace hairpaint::model
