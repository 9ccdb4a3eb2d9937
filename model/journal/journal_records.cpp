// Framing: see the header.
#include "model/journal/journal_records.h"

#include <QtEndian>

#include <zlib.h>

#include <array>

namespace hairpaint::model {

namespace {

constexpr std::uint32_t kMark = 0x4C4A5048; // "HPJL"
constexpr qsizetype kHeaderBytes = 16;

std::uint32_t checksum(QByteArrayView bytes)
{
    return static_cast<std::uint32_t>(
        ::crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
}

} // namespace

QByteArray recordBytes(RecordKind kind, QByteArrayView payload)
{
    const std::array<std::uint32_t, 4> header{kMark, static_cast<std::uint32_t>(kind),
                                              static_cast<std::uint32_t>(payload.size()), checksum(payload)};
    QByteArray bytes(kHeaderBytes, Qt::Uninitialized);
    qToLittleEndian<quint32>(header.data(), header.size(), bytes.data());
    bytes.append(payload);
    return bytes;
}

std::optional<JournalRecord> nextRecord(QIODevice& file)
{
    const QByteArray bytes = file.read(kHeaderBytes);
    if (bytes.size() != kHeaderBytes)
        return std::nullopt;
    std::array<std::uint32_t, 4> header{};
    qFromLittleEndian<quint32>(bytes.constData(), header.size(), header.data());
    // A size from a damaged header must not be asked of memory.
    if (header[0] != kMark || header[2] > kMostRecordBytes || header[2] > file.size() - file.pos())
        return std::nullopt;
    JournalRecord record{.kind = static_cast<RecordKind>(header[1]), .payload = file.read(header[2])};
    if (record.payload.size() != static_cast<qsizetype>(header[2]) || checksum(record.payload) != header[3])
        return std::nullopt;
    return record;
}

} // namespace hairpaint::model
