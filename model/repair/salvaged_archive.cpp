// Looking for headers, and inflating as far as it goes.
#include "model/repair/salvaged_archive.h"

#include "model/files/archive.h"

#include <QtEndian>

#define ZLIB_CONST // next_in only reads
#include <zlib.h>

#include <algorithm>
#include <new>

namespace hairpaint::model {

namespace {

constexpr qint64 kLocalBytes = 30;   ///< Bytes of a local header before its name (APPNOTE 4.3.7).
constexpr qint64 kCentralBytes = 46; ///< Bytes of a header in the directory before its name (4.3.12).
constexpr qint64 kScannedBytes = 1 << 20;
constexpr qint64 kSignatureBytes = 4;
constexpr int kLongestEntryName = 200;
constexpr std::size_t kMostHeaders = 4 * std::size_t{kMostArchiveEntries};
constexpr std::size_t kMostRecords = 8; ///< Limit on records kept for entries of one name.
constexpr quint16 kDeflated = 8;

const QByteArray kLocalMark("PK\x03\x04", 4);
const QByteArray kCentralMark("PK\x01\x02", 4);
const QByteArray kEndMark("PK\x05\x06", 4);

quint16 shortAt(const QByteArray& bytes, qsizetype at)
{
    return qFromLittleEndian<quint16>(bytes.constData() + at);
}

quint32 longAt(const QByteArray& bytes, qsizetype at)
{
    return qFromLittleEndian<quint32>(bytes.constData() + at);
}

quint32 crcOfBytes(const QByteArray& bytes)
{
    return static_cast<quint32>(
        crc32_z(0, reinterpret_cast<const Bytef*>(bytes.constData()), static_cast<std::size_t>(bytes.size())));
}

/// What a stream of raw deflate holds before it ends or breaks.
QByteArray inflated(const QByteArray& packed, qint64 mostBytes)
{
    constexpr int kRaw = -15; // The largest window, no header.
    z_stream stream{};
    QByteArray bytes;
    if (inflateInit2(&stream, kRaw) != Z_OK)
        throw std::bad_alloc(); // Nothing else can be wrong with it.
    const std::unique_ptr<z_stream, int (*)(z_stream*)> ended(&stream, inflateEnd);
    stream.next_in = reinterpret_cast<const Bytef*>(packed.constData());
    stream.avail_in = static_cast<uInt>(packed.size());
    QByteArray piece(kScannedBytes / 16, Qt::Uninitialized);
    int result = Z_OK;
    while (result == Z_OK && bytes.size() < mostBytes) {
        stream.next_out = reinterpret_cast<Bytef*>(piece.data());
        stream.avail_out = static_cast<uInt>(std::min<qint64>(piece.size(), mostBytes - bytes.size()));
        const uInt room = stream.avail_out;
        result = inflate(&stream, Z_NO_FLUSH);
        if (result == Z_MEM_ERROR)
            throw std::bad_alloc();
        bytes.append(piece.constData(), static_cast<qsizetype>(room - stream.avail_out));
    }
    return bytes;
}

bool isPlainName(const QByteArray& name)
{
    return !name.isEmpty() && std::ranges::all_of(name, [](char c) { return c > ' ' && c < '\x7F'; });
}

} // namespace

Checked<SalvagedArchive> SalvagedArchive::open(const QString& path, const std::function<bool()>& goesOn)
{
    SalvagedArchive archive;
    archive.m_file = std::make_unique<QFile>(path);
    if (!archive.m_file->open(QIODevice::ReadOnly))
        return refuse(readRefusal(archive.m_file->errorString()), Clause::Cure::OtherFile);
    if (Checked<void> found = archive.findHeaders(goesOn); !found)
        return tl::unexpected(found.error());
    return archive;
}

Checked<void> SalvagedArchive::findHeaders(const std::function<bool()>& goesOn)
{
    QByteArray piece;
    for (qint64 at = 0; at < m_file->size() && m_headers.size() < kMostHeaders; at += kScannedBytes) {
        if (goesOn && !goesOn())
            return {};
        piece = bytesAt(at, kScannedBytes + kSignatureBytes - 1); // A mark may lie across two pieces.
        for (qsizetype found = piece.indexOf("PK"); found >= 0 && found < kScannedBytes;
             found = piece.indexOf("PK", found + 1)) {
            const QByteArray mark = piece.mid(found, kSignatureBytes);
            if ((mark == kLocalMark || mark == kCentralMark || mark == kEndMark) && m_headers.size() < kMostHeaders)
                m_headers.push_back(at + found);
        }
    }
    for (const qint64 header : m_headers) {
        const QByteArray mark = bytesAt(header, kSignatureBytes);
        if (mark == kLocalMark)
            readLocal(header);
        else if (mark == kCentralMark)
            readCentral(header);
    }
    return {};
}

void SalvagedArchive::readLocal(qint64 at)
{
    const QByteArray header = bytesAt(at, kLocalBytes + kLongestEntryName);
    if (header.size() < kLocalBytes)
        return;
    const quint16 nameBytes = shortAt(header, 26);
    add(header.mid(kLocalBytes, nameBytes), {.at = at + kLocalBytes + nameBytes + shortAt(header, 28),
                                             .packedBytes = longAt(header, 18),
                                             .bytes = longAt(header, 22),
                                             .checksum = longAt(header, 14),
                                             .deflated = shortAt(header, 8) == kDeflated});
}

void SalvagedArchive::readCentral(qint64 at)
{
    const QByteArray header = bytesAt(at, kCentralBytes + kLongestEntryName);
    if (header.size() < kCentralBytes)
        return;
    const quint16 nameBytes = shortAt(header, 28);
    const qint64 local = longAt(header, 42);
    const QByteArray name = header.mid(kCentralBytes, nameBytes);
    Record record{.at = local + kLocalBytes + nameBytes,
                  .packedBytes = longAt(header, 20),
                  .bytes = longAt(header, 24),
                  .checksum = longAt(header, 16),
                  .deflated = shortAt(header, 10) == kDeflated};
    add(name, record);
    // Other programs write more into the local header than into this one.
    const QByteArray there = bytesAt(local, kLocalBytes);
    if (there.size() == kLocalBytes && there.startsWith(kLocalMark) && shortAt(there, 28) != 0) {
        record.at = local + kLocalBytes + shortAt(there, 26) + shortAt(there, 28);
        add(name, record);
    }
}

void SalvagedArchive::add(const QByteArray& name, const Record& record)
{
    if (!isPlainName(name) || record.at >= m_file->size())
        return;
    std::vector<Record>& records = m_entries[QString::fromLatin1(name)];
    bool isKnown = false;
    for (Record& known : records)
        if (known.at == record.at) {
            ++known.witnesses;
            isKnown = isKnown || (known.packedBytes == record.packedBytes && known.bytes == record.bytes &&
                                  known.checksum == record.checksum && known.deflated == record.deflated);
        }
    if (!isKnown && records.size() < kMostRecords)
        records.push_back(record);
}

QStringList SalvagedArchive::names() const
{
    QStringList names;
    for (const auto& [name, records] : m_entries)
        names.append(name);
    return names;
}

QByteArray SalvagedArchive::bytesAt(qint64 at, qint64 count)
{
    return m_file->seek(at) ? m_file->read(count) : QByteArray();
}

qint64 SalvagedArchive::endOf(qint64 at) const
{
    const auto next = std::ranges::lower_bound(m_headers, at);
    return next == m_headers.end() ? m_file->size() : *next;
}

SalvagedArchive::Content SalvagedArchive::contentOf(const Record& record, qint64 mostBytes)
{
    const auto isWhole = [&record](const QByteArray& bytes) { return crcOfBytes(bytes) == record.checksum; };
    // Its length may be what is damaged.
    const qint64 reach = endOf(record.at) - record.at;
    if (record.deflated) {
        const QByteArray packed = bytesAt(record.at, std::min(std::max(record.packedBytes, reach), mostBytes));
        QByteArray bytes = inflated(packed, mostBytes);
        const bool whole = isWhole(bytes);
        return {.bytes = std::move(bytes), .whole = whole};
    }
    QByteArray bytes = bytesAt(record.at, std::min(record.packedBytes, mostBytes));
    if (isWhole(bytes))
        return {.bytes = std::move(bytes), .whole = true};
    bytes = bytesAt(record.at, std::min(reach, mostBytes));
    const bool whole = isWhole(bytes);
    return {.bytes = std::move(bytes), .whole = whole};
}

std::optional<SalvagedArchive::Content> SalvagedArchive::read(const QString& name, qint64 mostBytes)
{
    const auto entry = m_entries.find(name);
    if (entry == m_entries.end())
        return std::nullopt;
    std::vector<Record>& records = entry->second;
    std::ranges::stable_sort(records, std::greater<>(), &Record::witnesses);
    std::optional<Content> best;
    for (const Record& record : records) {
        Content content = contentOf(record, mostBytes);
        if (content.whole)
            return content;
        if (!best || content.bytes.size() > best->bytes.size())
            best = std::move(content);
    }
    return best;
}

} // namespace hairpaint::model
