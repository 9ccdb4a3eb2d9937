// ZIP and PNG files made byte by byte, right or wrong, for tests of the readers.
#pragma once

#include <QByteArray>
#include <QFile>
#include <QString>
#include <QtEndian>

#include <functional>
#include <utility>
#include <vector>

namespace hairpaint::test {

inline quint32 crcOf(const QByteArray& bytes)
{
    quint32 c = 0xFFFFFFFFU;
    for (const char byte : bytes) {
        c ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit)
            c = (c & 1U) != 0 ? 0xEDB88320U ^ (c >> 1U) : c >> 1U;
    }
    return c ^ 0xFFFFFFFFU;
}

inline void append16(QByteArray& out, int value)
{
    out.append(static_cast<char>(value & 0xFF)).append(static_cast<char>((value >> 8) & 0xFF));
}

inline void append32(QByteArray& out, quint32 value)
{
    const quint32 little = qToLittleEndian(value);
    out.append(reinterpret_cast<const char*>(&little), 4);
}

struct ZipEntry
{
    QByteArray name;
    QByteArray bytes; ///< The packed content.
    int method = 0;   ///< 0 stored, 8 deflated.
    quint32 size = 0; ///< Size of the unpacked content as the headers claim it; 0 takes that of `bytes`.
    quint32 crc = 0;  ///< CRC-32 of the unpacked content as the headers claim it; 0 takes that of `bytes`.
    int flags = 0;
};

inline QByteArray makeZip(const std::vector<ZipEntry>& entries, const QByteArray& comment = {})
{
    QByteArray out;
    QByteArray directory;
    for (const ZipEntry& entry : entries) {
        QByteArray common;
        append16(common, 20);
        append16(common, entry.flags);
        append16(common, entry.method);
        append16(common, 0);
        append16(common, 33);
        append32(common, entry.crc != 0 ? entry.crc : crcOf(entry.bytes));
        append32(common, static_cast<quint32>(entry.bytes.size()));
        append32(common, entry.size != 0 ? entry.size : static_cast<quint32>(entry.bytes.size()));
        append16(common, static_cast<int>(entry.name.size()));
        append16(common, 0);
        directory.append("PK\x01\x02", 4);
        append16(directory, 20);
        directory.append(common);
        append16(directory, 0);
        append16(directory, 0);
        append16(directory, 0);
        append32(directory, 0);
        append32(directory, static_cast<quint32>(out.size()));
        directory.append(entry.name);
        out.append("PK\x03\x04", 4).append(common).append(entry.name).append(entry.bytes);
    }
    const auto directoryAt = static_cast<quint32>(out.size());
    out.append(directory);
    out.append("PK\x05\x06", 4);
    append32(out, 0);
    append16(out, static_cast<int>(entries.size()));
    append16(out, static_cast<int>(entries.size()));
    append32(out, static_cast<quint32>(directory.size()));
    append32(out, directoryAt);
    append16(out, static_cast<int>(comment.size()));
    return out + comment;
}

/// Raw deflate, as ZIP has it: zlib's stream without its header and checksum.
inline QByteArray deflated(const QByteArray& bytes)
{
    return qCompress(bytes, 9).sliced(6).chopped(4);
}

inline QByteArray pngChunk(const QByteArray& type, const QByteArray& data)
{
    const auto big = [](quint32 value) {
        const quint32 swapped = qToBigEndian(value);
        return QByteArray(reinterpret_cast<const char*>(&swapped), 4);
    };
    return big(static_cast<quint32>(data.size())) + type + data + big(crcOf(type + data));
}

inline QByteArray pngHeader(quint32 width, quint32 height, int depth, int colourType, int interlace = 0)
{
    QByteArray data(13, '\0');
    qToBigEndian(width, data.data());
    qToBigEndian(height, data.data() + 4);
    data[8] = static_cast<char>(depth);
    data[9] = static_cast<char>(colourType);
    data[12] = static_cast<char>(interlace);
    return pngChunk("IHDR", data);
}

inline QByteArray pngSignature()
{
    return QByteArray("\x89PNG\r\n\x1a\n", 8);
}

/// A zlib stream of `count` zeros.
inline QByteArray packedZeros(qint64 count)
{
    return qCompress(QByteArray(count, '\0'), 1).sliced(4);
}

/// `packed`: the pixels as one zlib stream.
inline QByteArray pngOf(quint32 width, quint32 height, int depth, int colourType, const QByteArray& packed)
{
    return pngSignature() + pngHeader(width, height, depth, colourType) + pngChunk("IDAT", packed) +
           pngChunk("IEND", {});
}

/// Where the bytes of an entry lie in a file.
struct EntrySpan
{
    QString name;
    qsizetype at = 0;
    qsizetype end = 0;
};

/// Spans of all entries in their order, for archives with the sizes in the local headers.
inline std::vector<EntrySpan> spansOf(const QByteArray& bytes)
{
    std::vector<EntrySpan> spans;
    const QByteArray mark("PK\x03\x04", 4);
    for (qsizetype at = bytes.indexOf(mark); at >= 0; at = bytes.indexOf(mark, at)) {
        const auto packed = qFromLittleEndian<quint32>(bytes.constData() + at + 18);
        const auto nameBytes = qFromLittleEndian<quint16>(bytes.constData() + at + 26);
        const qsizetype begin = at + 30 + nameBytes;
        spans.push_back({.name = QString::fromLatin1(bytes.sliced(at + 30, nameBytes)),
                         .at = begin,
                         .end = begin + static_cast<qsizetype>(packed)});
        at = spans.back().end;
    }
    return spans;
}

inline void writeBytes(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    if (file.open(QIODevice::WriteOnly))
        file.write(bytes);
}

inline QByteArray readBytes(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace hairpaint::test
