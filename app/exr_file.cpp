// Writes the header, the table of blocks and the blocks.
#include "app/exr_file.h"

#include <QtEndian>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace hairpaint::app {
namespace {

constexpr int kLinesOfBlock = 16; ///< That ZIP compresses together.
constexpr std::array kChannels{std::pair{'A', 3}, std::pair{'B', 2}, std::pair{'G', 1}, std::pair{'R', 0}};

template<class T>
void append(QByteArray& bytes, T value)
{
    const T little = qToLittleEndian(value);
    bytes.append(reinterpret_cast<const char*>(&little), sizeof little);
}

void appendFloat(QByteArray& bytes, float value)
{
    append(bytes, std::bit_cast<std::uint32_t>(value));
}

/// A name, its type, and what it is.
void appendAttribute(QByteArray& bytes, const char* name, const char* type, const QByteArray& value)
{
    bytes.append(name).append('\0').append(type).append('\0');
    append(bytes, static_cast<std::int32_t>(value.size()));
    bytes.append(value);
}

QByteArray header(QSize size)
{
    QByteArray channels;
    for (const auto& [name, offset] : kChannels) {
        constexpr std::int32_t kFloat = 2;
        channels.append(name).append('\0');
        append(channels, kFloat);
        append(channels, std::int32_t{0}); // Linear or not, for lossy compression only; reserved.
        append(channels, std::int32_t{1}); // Every sample, across and up.
        append(channels, std::int32_t{1});
    }
    channels.append('\0');
    QByteArray window;
    for (const int edge : {0, 0, size.width() - 1, size.height() - 1})
        append(window, static_cast<std::int32_t>(edge));
    QByteArray one;
    appendFloat(one, 1.0F);
    constexpr char kZip = 3;
    constexpr char kIncreasing = 0;
    QByteArray bytes("\x76\x2f\x31\x01\x02\x00\x00\x00", 8);
    appendAttribute(bytes, "channels", "chlist", channels);
    appendAttribute(bytes, "compression", "compression", QByteArray(1, kZip));
    appendAttribute(bytes, "dataWindow", "box2i", window);
    appendAttribute(bytes, "displayWindow", "box2i", window);
    appendAttribute(bytes, "lineOrder", "lineOrder", QByteArray(1, kIncreasing));
    appendAttribute(bytes, "pixelAspectRatio", "float", one);
    appendAttribute(bytes, "screenWindowCenter", "v2f", QByteArray(8, '\0'));
    appendAttribute(bytes, "screenWindowWidth", "float", one);
    return bytes.append('\0');
}

/// Lines of the block, channel by channel.
QByteArray linesOf(std::span<const float> rgba, int width, int first, int end)
{
    QByteArray lines;
    lines.reserve(static_cast<qsizetype>(end - first) * width * 16);
    for (int y = first; y < end; ++y)
        for (const auto& [name, offset] : kChannels)
            for (int x = 0; x < width; ++x)
                appendFloat(
                    lines,
                    rgba[(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
                             4 +
                         static_cast<std::size_t>(offset)]);
    return lines;
}

/// Even bytes before odd ones, then each as its difference from the one before.
QByteArray zipped(const QByteArray& lines)
{
    QByteArray parted(lines.size(), Qt::Uninitialized);
    const qsizetype odd = (lines.size() + 1) / 2;
    for (qsizetype i = 0; i < lines.size(); ++i)
        parted[i / 2 + (i % 2 != 0 ? odd : 0)] = lines[i];
    for (qsizetype i = parted.size() - 1; i > 0; --i)
        parted[i] = static_cast<char>(parted[i] - parted[i - 1] + 128);
    constexpr int kLevel = 4;
    constexpr qsizetype kQtsOwn = 4; // The length, which Qt puts in front.
    const QByteArray packed = qCompress(parted, kLevel).mid(kQtsOwn);
    return packed.size() < lines.size() ? packed : lines;
}

} // namespace

QByteArray exrBytes(std::span<const float> rgba, QSize size)
{
    QByteArray bytes = header(size);
    const int blocks = (size.height() + kLinesOfBlock - 1) / kLinesOfBlock;
    const qsizetype table = bytes.size();
    bytes.append(QByteArray(8 * static_cast<qsizetype>(blocks), '\0'));
    for (int block = 0; block < blocks; ++block) {
        qToLittleEndian(static_cast<std::uint64_t>(bytes.size()), bytes.data() + table + 8 * qsizetype{block});
        const int first = block * kLinesOfBlock;
        const QByteArray data =
            zipped(linesOf(rgba, size.width(), first, std::min(first + kLinesOfBlock, size.height())));
        append(bytes, static_cast<std::int32_t>(first));
        append(bytes, static_cast<std::int32_t>(data.size()));
        bytes.append(data);
    }
    return bytes;
}

} // namespace hairpaint::app
