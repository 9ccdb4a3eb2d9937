// Small images as other programs write them, byte by byte.
#pragma once

#include <QByteArray>
#include <QList>
#include <QtEndian>

#include <array>
#include <cstring>

namespace hairpaint::test {

template<typename T>
void put(QByteArray& bytes, T value)
{
    std::array<char, sizeof(T)> raw{};
    std::memcpy(raw.data(), &value, sizeof(T));
    bytes.append(raw.data(), sizeof(T));
}

struct TiffSample
{
    quint32 width = 1, height = 1;
    quint16 bits = 8;
    quint16 samples = 1;
    quint16 photometric = 1;
    int extra = -1; ///< -1: no tag of extra samples.
    bool tellsBits = true;
    QByteArray profile = {}; ///< ICC; even in length.
    QByteArray data = {};
};

/// Little-endian, uncompressed, one strip.
inline QByteArray tiff(const TiffSample& sample)
{
    struct Entry
    {
        quint16 tag, type;
        quint32 count, value;
    };
    QByteArray bytes("II*\0", 4);
    QByteArray data = sample.data;
    if (data.size() % 2 != 0)
        data += '\0';
    const auto bitsAt = static_cast<quint32>(8 + data.size());
    put(bytes, static_cast<quint32>(bitsAt + 8 + sample.profile.size()));
    bytes += data;
    for (int i = 0; i < 4; ++i)
        put(bytes, sample.bits);
    bytes += sample.profile;
    QList<Entry> entries{{256, 4, 1, sample.width}, {257, 4, 1, sample.height}};
    if (sample.tellsBits)
        entries += Entry{258, 3, sample.samples,
                         sample.samples == 1   ? sample.bits
                         : sample.samples == 2 ? sample.bits | quint32{sample.bits} << 16U
                                               : bitsAt};
    entries += {{259, 3, 1, 1},
                {262, 3, 1, sample.photometric},
                {273, 4, 1, 8},
                {277, 3, 1, sample.samples},
                {278, 4, 1, sample.height},
                {279, 4, 1, static_cast<quint32>(sample.data.size())}};
    if (sample.extra >= 0)
        entries += Entry{338, 3, 1, static_cast<quint32>(sample.extra)};
    if (!sample.profile.isEmpty())
        entries += Entry{34675, 7, static_cast<quint32>(sample.profile.size()), bitsAt + 8};
    put(bytes, static_cast<quint16>(entries.size()));
    for (const Entry& entry : entries) {
        put(bytes, entry.tag);
        put(bytes, entry.type);
        put(bytes, entry.count);
        put(bytes, entry.value);
    }
    put(bytes, quint32{0});
    return bytes;
}

/// Uncompressed floats by scan lines; `names` in alphabetical order, `values`: one a channel, the same in every pixel
/// of the data window of `width` x 1 at (`left`, 0). The display window is `shownWidth` x 1 at (0, 0).
inline QByteArray exr(const QList<QByteArray>& names, const QList<float>& values, qint32 left, qint32 width,
                      qint32 shownWidth)
{
    QByteArray bytes("\x76\x2f\x31\x01\x02\0\0\0", 8);
    const auto attribute = [&bytes](const QByteArray& name, const QByteArray& type, const QByteArray& value) {
        bytes += name + '\0' + type + '\0';
        put(bytes, static_cast<qint32>(value.size()));
        bytes += value;
    };
    const auto box = [](qint32 x0, qint32 x1) {
        QByteArray value;
        for (const qint32 side : {x0, 0, x1, 0})
            put(value, side);
        return value;
    };
    QByteArray channels;
    for (const QByteArray& name : names) {
        channels += name + '\0';
        for (const qint32 field : {2, 0, 1, 1}) // Float, as it is, every pixel.
            put(channels, field);
    }
    channels += '\0';
    QByteArray one;
    put(one, 1.0F);
    attribute("channels", "chlist", channels);
    attribute("compression", "compression", QByteArray(1, '\0'));
    attribute("dataWindow", "box2i", box(left, left + width - 1));
    attribute("displayWindow", "box2i", box(0, shownWidth - 1));
    attribute("lineOrder", "lineOrder", QByteArray(1, '\0'));
    attribute("pixelAspectRatio", "float", one);
    attribute("screenWindowCenter", "v2f", QByteArray(8, '\0'));
    attribute("screenWindowWidth", "float", one);
    bytes += '\0';
    put(bytes, static_cast<quint64>(bytes.size()) + 8);
    put(bytes, qint32{0});
    put(bytes, static_cast<qint32>(width * 4 * names.size()));
    for (const float value : values)
        for (qint32 x = 0; x < width; ++x)
            put(bytes, value);
    return bytes;
}

/// One pixel of 32 bits with a header of 40 bytes, which gives the fourth no meaning.
inline QByteArray bmp32(const QByteArray& bgrx)
{
    QByteArray bytes("BM");
    for (const quint32 field : {58U, 0U, 54U, 40U, 1U, 1U})
        put(bytes, field);
    put(bytes, quint16{1});
    put(bytes, quint16{32});
    for (const quint32 field : {0U, 4U, 2835U, 2835U, 0U, 0U})
        put(bytes, field);
    return bytes + bgrx;
}

/// RGB of 8 bits, 1 x 1; `hasMerged`: what its resource 1057 says.
inline QByteArray psd(bool hasMerged)
{
    QByteArray bytes("8BPS\0\1\0\0\0\0\0\0\0\3\0\0\0\1\0\0\0\1\0\x08\0\3\0\0\0\0", 30);
    QByteArray resource("8BIM\x04\x21\0\0\0\0\0\x05\0\0\0\1", 16);
    resource += hasMerged ? '\1' : '\0';
    resource += '\0';
    bytes += QByteArray("\0\0\0", 3) + static_cast<char>(resource.size()) + resource;
    return bytes + QByteArray(4, '\0') + QByteArray(2, '\0') + QByteArray("\x80\x40\x20");
}

/// Two pixels without loss: 200 100 50 with alpha 128, and 10 20 30.
inline QByteArray webp()
{
    return QByteArray::fromHex("5249464622000000574542505650384c160000002f010000100f700aa82bf89ec2e381ffc1838ce87f00");
}
/// Two pixels, 200 100 50 and 10 20 30, that EXIF has turned by half a turn.
inline QByteArray turnedWebp()
{
    return QByteArray::fromHex(
        "524946465600000057454250565038580a000000080000000100000000005650384c150000002f010000000f700aa82bf89e"
        "c263fe830719d1ff0000455849461a0000004d4d002a00000008000101120003000000010003000000000000");
}

} // namespace hairpaint::test
