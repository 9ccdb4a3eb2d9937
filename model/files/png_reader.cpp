// Chunks, inflating and unfiltering.
#include "model/files/png_reader.h"

#include <QtEndian>

#define ZLIB_CONST // next_in only reads
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <new>
#include <vector>

namespace hairpaint::model {

namespace {

constexpr std::array<char, 8> kSignature = {'\x89', 'P', 'N', 'G', '\r', '\n', '\x1a', '\n'};
constexpr std::size_t kFrameBytes = 12; // length, type and checksum around a chunk's data
constexpr quint32 kLongestChunk = 0x7FFFFFFF;
constexpr QByteArrayView kPixels("IDAT");

QByteArrayView partOf(const QByteArray& bytes, std::size_t begin, std::size_t end)
{
    return QByteArrayView(bytes).sliced(static_cast<qsizetype>(begin), static_cast<qsizetype>(end - begin));
}

quint32 checksum(const char* bytes, std::size_t count, quint32 before = 0)
{
    return static_cast<quint32>(crc32_z(before, reinterpret_cast<const Bytef*>(bytes), count));
}

bool readHeader(const char* data, quint32 length, PngParts& parts)
{
    if (length != 13)
        return false;
    parts.width = qFromBigEndian<quint32>(data);
    parts.height = qFromBigEndian<quint32>(data + 4);
    parts.depth = static_cast<unsigned char>(data[8]);
    parts.colourType = static_cast<unsigned char>(data[9]);
    parts.interlaced = data[12] != 0;
    return parts.width > 0 && parts.height > 0 && data[10] == 0 && data[11] == 0;
}

/// Undoes the filter of a row (PNG specification, 9.2); `above`: the unfiltered row before, zeros at the top. False
/// where there is no such filter.
template<int pixelBytes>
bool unfilter(int filter, std::uint8_t* row, const std::uint8_t* above, std::size_t count)
{
    const auto byte = [](int value) { return static_cast<std::uint8_t>(value); };
    constexpr std::size_t kPixel = pixelBytes;
    switch (filter) {
    case 0:
        return true;
    case 1:
        for (std::size_t i = kPixel; i < count; ++i)
            row[i] = byte(row[i] + row[i - kPixel]);
        return true;
    case 2:
        for (std::size_t i = 0; i < count; ++i)
            row[i] = byte(row[i] + above[i]);
        return true;
    case 3:
        for (std::size_t i = 0; i < count; ++i)
            row[i] = byte(row[i] + ((i < kPixel ? 0 : row[i - kPixel]) + above[i]) / 2);
        return true;
    case 4: {
        // Paeth's: whichever of left, above and above left is nearest to left + above - above left.
        std::array<int, kPixel> left{};
        std::array<int, kPixel> aboveLeft{};
        for (std::size_t at = 0; at < count; at += kPixel)
            for (std::size_t i = 0; i < kPixel; ++i) {
                const int up = above[at + i];
                const int toLeft = std::abs(up - aboveLeft[i]);
                const int toUp = std::abs(left[i] - aboveLeft[i]);
                const int toBoth = std::abs(left[i] + up - 2 * aboveLeft[i]);
                const int other = toUp <= toBoth ? up : aboveLeft[i];
                const int guess = toLeft <= toUp && toLeft <= toBoth ? left[i] : other;
                row[at + i] = byte(row[at + i] + guess);
                left[i] = row[at + i];
                aboveLeft[i] = up;
            }
        return true;
    }
    default:
        return false;
    }
}

/// A row of `pixelBytes` a pixel; before it, as before the one `above`, stands its filter's number.
bool unfilterRow(int pixelBytes, std::uint8_t* row, const std::uint8_t* above, std::size_t rowBytes)
{
    const int filter = row[0];
    switch (pixelBytes) {
    case 2:
        return unfilter<2>(filter, row + 1, above + 1, rowBytes);
    case 3:
        return unfilter<3>(filter, row + 1, above + 1, rowBytes);
    case 4:
        return unfilter<4>(filter, row + 1, above + 1, rowBytes);
    case 6:
        return unfilter<6>(filter, row + 1, above + 1, rowBytes);
    default:
        return unfilter<8>(filter, row + 1, above + 1, rowBytes);
    }
}

} // namespace

std::optional<PngParts> readPngParts(const QByteArray& png)
{
    if (png.size() < 8 || std::memcmp(png.constData(), kSignature.data(), kSignature.size()) != 0)
        return std::nullopt;
    PngParts parts;
    parts.checksum = checksum(png.constData(), kSignature.size());
    bool sawHeader = false;
    std::size_t firstPixels = 0;
    std::size_t pixelsEnd = 0;
    const auto size = static_cast<std::size_t>(png.size());
    for (std::size_t at = kSignature.size(); at + kFrameBytes <= size;) {
        const char* chunk = png.constData() + at;
        const auto length = qFromBigEndian<quint32>(chunk);
        if (length > kLongestChunk || length > size - at - kFrameBytes)
            return std::nullopt;
        const quint32 content = checksum(chunk + 4, std::size_t{length} + 4);
        if (content != qFromBigEndian<quint32>(chunk + 8 + length))
            return std::nullopt;
        parts.checksum = checksum(chunk, 4, parts.checksum);
        parts.checksum = static_cast<quint32>(crc32_combine(parts.checksum, content, static_cast<z_off_t>(length) + 4));
        parts.checksum = checksum(chunk + 8 + length, 4, parts.checksum);
        const QByteArrayView type(chunk + 4, 4);
        const bool isHeader = type == QByteArrayView("IHDR");
        if (isHeader == sawHeader || (isHeader && !readHeader(chunk + 8, length, parts)))
            return std::nullopt;
        sawHeader = true;
        at += kFrameBytes + length;
        if (type == QByteArrayView("IEND")) {
            if (at != size || pixelsEnd == 0)
                return std::nullopt;
            parts.pixelChunks = partOf(png, firstPixels, pixelsEnd);
            return parts;
        }
        const bool isAncillary = (static_cast<unsigned char>(chunk[4]) & 0x20U) != 0;
        if (type == kPixels) {
            firstPixels = pixelsEnd == 0 ? at - kFrameBytes - length : firstPixels;
            pixelsEnd = at;
        } else if (!isHeader && !isAncillary && type != QByteArrayView("PLTE")) {
            return std::nullopt;
        } else if (!isHeader) {
            parts.onlyPixelsAndDpi = parts.onlyPixelsAndDpi && type == QByteArrayView("pHYs");
        }
    }
    return std::nullopt;
}

std::optional<PngParts> readPngHeader(const QByteArray& png)
{
    constexpr quint32 kHeaderBytes = 13;
    const char* chunk = png.constData() + kSignature.size();
    PngParts parts;
    if (png.size() < qsizetype{kSignature.size() + kFrameBytes + kHeaderBytes} ||
        QByteArrayView(chunk + 4, 4) != QByteArrayView("IHDR") ||
        checksum(chunk + 4, kHeaderBytes + 4) != qFromBigEndian<quint32>(chunk + 8 + kHeaderBytes) ||
        !readHeader(chunk + 8, qFromBigEndian<quint32>(chunk), parts))
        return std::nullopt;
    return parts;
}

QByteArrayView pixelChunksOf(const QByteArray& png)
{
    std::size_t firstPixels = 0;
    std::size_t pixelsEnd = 0;
    const auto size = static_cast<std::size_t>(png.size());
    for (std::size_t at = kSignature.size(); at + kFrameBytes <= size;) {
        const char* chunk = png.constData() + at;
        const auto length = qFromBigEndian<quint32>(chunk);
        const bool isPixels = QByteArrayView(chunk + 4, 4) == kPixels;
        const bool isCut = length > size - at - kFrameBytes;
        const bool isGood =
            isCut || checksum(chunk + 4, std::size_t{length} + 4) == qFromBigEndian<quint32>(chunk + 8 + length);
        if (!isGood && (isPixels || pixelsEnd != 0))
            break; // One before the pixels says nothing that is not known of a layer.
        if (isPixels) {
            firstPixels = pixelsEnd == 0 ? at : firstPixels;
            pixelsEnd = isCut ? size : at + kFrameBytes + length;
        }
        if (isCut)
            break;
        at += kFrameBytes + length;
    }
    return partOf(png, firstPixels, pixelsEnd);
}

/// What is no row of bands, through zlib, as far as it is whole.
struct PngRows::Stream
{
    z_stream zlib{};
    bool good = false;
    bool ended = false;
    std::vector<std::uint8_t> row; ///< The filter's number, then the row.
    QByteArrayView chunks;         ///< Not begun yet.

    Stream(QByteArrayView pixelChunks, std::size_t rowBytes) : row(rowBytes + 1), chunks(pixelChunks)
    {
        const int result = inflateInit(&zlib);
        if (result == Z_MEM_ERROR)
            throw std::bad_alloc();
        good = result == Z_OK;
    }
    ~Stream() { inflateEnd(&zlib); }
    Stream(const Stream&) = delete;
    Stream& operator=(const Stream&) = delete;

    /// Inflates `count` bytes; false where there are fewer.
    bool inflateTo(std::uint8_t* target, std::size_t count)
    {
        zlib.next_out = target;
        zlib.avail_out = static_cast<uInt>(count);
        while (zlib.avail_out > 0 && good && !ended) {
            if (zlib.avail_in == 0) {
                const std::optional<QByteArrayView> content = takePixelChunk(chunks);
                good = content.has_value();
                if (!good)
                    break;
                zlib.next_in = reinterpret_cast<const Bytef*>(content->data());
                zlib.avail_in = static_cast<uInt>(content->size());
            }
            const int result = inflate(&zlib, Z_NO_FLUSH);
            if (result == Z_MEM_ERROR)
                throw std::bad_alloc(); // Its own, and no damage.
            ended = result == Z_STREAM_END;
            good = ended || result == Z_OK;
        }
        return good && zlib.avail_out == 0;
    }
};

PngRows::PngRows(QByteArrayView pixelChunks, std::size_t rowBytes, int pixelBytes)
    : m_chunks(pixelChunks), m_rowBytes(rowBytes), m_pixelBytes(pixelBytes),
      m_bands(std::make_unique<PngBands>(pixelChunks, rowBytes)), m_above(rowBytes + 1)
{}

PngRows::~PngRows() = default;

std::span<const std::uint8_t> PngRows::nextOfBands()
{
    if (m_band.empty())
        m_band = m_bands->next();
    if (m_band.empty())
        return {};
    const std::span<std::uint8_t> row = m_band.first(m_rowBytes + 1);
    if (!unfilterRow(m_pixelBytes, row.data(), m_above.data(), m_rowBytes)) {
        m_band = {};
        return {};
    }
    m_band = m_band.subspan(row.size());
    std::ranges::copy(row, m_above.begin());
    ++m_given;
    return row.subspan(1);
}

std::span<const std::uint8_t> PngRows::next()
{
    if (m_bands) {
        const std::span<const std::uint8_t> row = nextOfBands();
        if (!row.empty() || m_bands->atEnd())
            return row;
        // Nothing stands alone from here on: from the start again, past the rows that were given.
        m_bands.reset();
        m_stream = std::make_unique<Stream>(m_chunks, m_rowBytes);
        for (std::size_t i = 0; i < m_given; ++i)
            (void)m_stream->inflateTo(m_stream->row.data(), m_stream->row.size());
    }
    Stream& stream = *m_stream;
    if (!stream.inflateTo(stream.row.data(), stream.row.size()) ||
        !unfilterRow(m_pixelBytes, stream.row.data(), m_above.data(), m_rowBytes)) {
        stream.good = false;
        return {};
    }
    m_above.swap(stream.row);
    return {m_above.data() + 1, m_rowBytes};
}

bool PngRows::atEnd()
{
    if (m_bands)
        return m_bands->atEnd() && m_band.empty();
    std::uint8_t more = 0;
    // What is left is the stream's checksum, and no pixel.
    return m_stream->good && !m_stream->inflateTo(&more, 1) && m_stream->good && m_stream->ended;
}

} // namespace hairpaint::model
