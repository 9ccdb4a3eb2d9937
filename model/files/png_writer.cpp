// Filters (PNG specification, section 9), zlib and chunks.
#include "model/files/png_writer.h"

#include "model/files/pixel_huffman.h"
#include "model/files/zip_records.h"

#include <QtEndian>

#define ZLIB_CONST // next_in only reads
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <new>

namespace hairpaint::model {

namespace {

constexpr std::size_t kPixel = 8; ///< Bytes.
constexpr int kFilters = 5;
constexpr quint32 kDotsAMetre = 2835; // 72 to an inch

using RowBytes = std::span<const std::uint8_t>;

std::uint8_t byteOf(int value)
{
    return static_cast<std::uint8_t>(value);
}

/// Writes the row as the filter leaves it. A pixel of zeros lies before `row` and `above`.
void filterRow(int filter, RowBytes row, const std::uint8_t* above, std::uint8_t* target)
{
    const std::uint8_t* at = row.data();
    const std::size_t count = row.size();
    switch (filter) {
    case 0:
        std::copy_n(at, count, target);
        return;
    case 1:
        for (std::size_t i = 0; i < count; ++i)
            target[i] = byteOf(at[i] - *(at + i - kPixel));
        return;
    case 2:
        for (std::size_t i = 0; i < count; ++i)
            target[i] = byteOf(at[i] - above[i]);
        return;
    case 3:
        for (std::size_t i = 0; i < count; ++i)
            target[i] = byteOf(at[i] - (*(at + i - kPixel) + above[i]) / 2);
        return;
    default:
        // Paeth's: whichever of left, above and above left is nearest to left + above - above left.
        for (std::size_t i = 0; i < count; ++i) {
            const auto left = static_cast<std::int16_t>(*(at + i - kPixel));
            const auto up = static_cast<std::int16_t>(above[i]);
            const auto aboveLeft = static_cast<std::int16_t>(*(above + i - kPixel));
            const auto toLeft = static_cast<std::int16_t>(std::abs(up - aboveLeft));
            const auto toUp = static_cast<std::int16_t>(std::abs(left - aboveLeft));
            const auto toBoth = static_cast<std::int16_t>(std::abs(left + up - 2 * aboveLeft));
            const std::int16_t other = toUp <= toBoth ? up : aboveLeft;
            const std::int16_t guess = toLeft <= toUp && toLeft <= toBoth ? left : other;
            target[i] = byteOf(at[i] - guess);
        }
    }
}

/// How far the bytes lie from 0, of either sign.
std::uint32_t distanceFromZero(const std::uint8_t* bytes, std::size_t count)
{
    std::uint32_t sum = 0;
    for (std::size_t i = 0; i < count; ++i)
        sum += std::min<std::uint32_t>(bytes[i], 256U - bytes[i]);
    return sum;
}

/// Filters one row after another, each as its bytes come nearest to 0.
class RowFilter
{
public:
    explicit RowFilter(const PngRowBuffer& rows) : m_rows(rows), m_best(1 + rows.row(0).size()), m_tried(m_best) {}

    /// The filter's number and the row; good until the next call. The top one refers to no other row.
    RowBytes filtered(int y)
    {
        const RowBytes row = m_rows.row(y);
        const std::uint8_t* above = y > 0 ? m_rows.row(y - 1).data() : nullptr;
        std::uint32_t least = std::numeric_limits<std::uint32_t>::max();
        for (int filter = 0; filter < (above == nullptr ? 2 : kFilters); ++filter) {
            m_tried[0] = byteOf(filter);
            filterRow(filter, row, above, m_tried.data() + 1);
            const std::uint32_t distance = distanceFromZero(m_tried.data() + 1, row.size());
            if (distance < least) {
                least = distance;
                std::swap(m_best, m_tried);
            }
        }
        return m_best;
    }

private:
    const PngRowBuffer& m_rows;
    std::vector<std::uint8_t> m_best;
    std::vector<std::uint8_t> m_tried;
};

/// A deflate stream without zlib's header, at its fastest.
class Deflater
{
public:
    Deflater()
    {
        constexpr int kWindowBits = -15; // No header.
        constexpr int kMemory = 8;
        if (deflateInit2(&m_stream, 1, Z_DEFLATED, kWindowBits, kMemory, Z_FILTERED) != Z_OK)
            throw std::bad_alloc(); // Nothing else can fail.
    }
    ~Deflater() { deflateEnd(&m_stream); }
    Deflater(const Deflater&) = delete;
    Deflater& operator=(const Deflater&) = delete;

    void add(RowBytes bytes) { run(bytes, Z_NO_FLUSH); }
    /// Ends on a whole byte, but not the stream; all that was added.
    [[nodiscard]] QByteArray takeFlushed()
    {
        run({}, Z_SYNC_FLUSH);
        m_packed.truncate(static_cast<qsizetype>(m_stream.total_out));
        return std::move(m_packed);
    }

private:
    void run(RowBytes bytes, int flush)
    {
        m_stream.next_in = bytes.data();
        m_stream.avail_in = static_cast<uInt>(bytes.size());
        do {
            constexpr qsizetype kLeast = 1 << 14;
            const auto done = static_cast<qsizetype>(m_stream.total_out);
            if (m_packed.size() < done + kLeast)
                m_packed.resize(std::max(m_packed.size() * 2, done + 2 * kLeast));
            m_stream.next_out = reinterpret_cast<Bytef*>(m_packed.data() + done);
            m_stream.avail_out = static_cast<uInt>(m_packed.size() - done);
            deflate(&m_stream, flush);
        } while (m_stream.avail_out == 0);
    }

    z_stream m_stream{};
    QByteArray m_packed;
};

/// What zlib would leave of the rows, 0..1, from some of them.
double zlibsRatio(const PngRowBuffer& rows)
{
    constexpr int kEvery = 32;
    constexpr int kFirst = 15;
    RowFilter filter(rows);
    Deflater deflater;
    std::size_t plainBytes = 0;
    for (int y = kFirst; y < rows.rows(); y += y % kEvery == kFirst ? 1 : kEvery - 1) {
        const RowBytes row = filter.filtered(y);
        plainBytes += row.size();
        deflater.add(row);
    }
    return plainBytes == 0 ? 1.0 : static_cast<double>(deflater.takeFlushed().size()) / static_cast<double>(plainBytes);
}

/// Whether Huffman codes alone make hardly more of the rows than zlib does, or less.
bool isNoise(const PngRowBuffer& rows, const PixelHuffman& codes, std::size_t plainBytes)
{
    const double ratio = static_cast<double>(codes.packedBytes()) / static_cast<double>(plainBytes);
    constexpr double kHardlyNoise = 0.25; // One value in three bits or less: zlib finds more.
    constexpr double kHardlyMore = 1.01;
    return ratio > kHardlyNoise && ratio <= kHardlyMore * zlibsRatio(rows);
}

std::uint32_t adlerOf(std::uint32_t before, RowBytes bytes)
{
    return static_cast<std::uint32_t>(adler32_z(before, bytes.data(), bytes.size()));
}

/// Bytes and their CRC-32.
struct Checked32
{
    Checked32(QByteArrayView view) : bytes(view), checksum(checksumOf(view)) {}
    Checked32(QByteArrayView view, std::uint32_t known) : bytes(view), checksum(known) {}
    QByteArrayView bytes;
    std::uint32_t checksum;
};

/// Appends them to what `checksum` is of.
void join(std::uint32_t& checksum, const Checked32& part)
{
    checksum =
        static_cast<std::uint32_t>(crc32_combine(checksum, part.checksum, static_cast<z_off_t>(part.bytes.size())));
}

void addPlain(PngFile& png, QByteArrayView bytes)
{
    png.bytes.append(bytes);
    join(png.checksum, bytes);
}

void addChunk(PngFile& png, const char* type, std::initializer_list<Checked32> parts)
{
    qsizetype length = 0;
    Checked32 content(QByteArrayView(type, 4));
    for (const Checked32& part : parts) {
        length += part.bytes.size();
        join(content.checksum, part);
    }
    std::array<char, 4> number{};
    qToBigEndian(static_cast<quint32>(length), number.data());
    addPlain(png, number);
    png.bytes.append(type, 4);
    for (const Checked32& part : parts)
        png.bytes.append(part.bytes);
    content.bytes = QByteArrayView(png.bytes).last(length + 4);
    join(png.checksum, content);
    qToBigEndian(content.checksum, number.data());
    addPlain(png, number);
}

} // namespace

PngRowBuffer::PngRowBuffer(int width, int rows)
    : m_rowBytes(kPixel * static_cast<std::size_t>(width)), m_rows(rows),
      m_bytes((m_rowBytes + kPixel) * static_cast<std::size_t>(rows))
{}

std::span<std::uint8_t> PngRowBuffer::row(int y)
{
    return std::span(m_bytes).subspan((m_rowBytes + kPixel) * static_cast<std::size_t>(y) + kPixel, m_rowBytes);
}

std::span<const std::uint8_t> PngRowBuffer::row(int y) const
{
    return std::span(m_bytes).subspan((m_rowBytes + kPixel) * static_cast<std::size_t>(y) + kPixel, m_rowBytes);
}

PngBand packBand(const PngRowBuffer& rows)
{
    const auto count = static_cast<std::size_t>(rows.rows());
    PngBand band{.packed = {}, .packedChecksum = 0, .checksum = 1, .plainBytes = count * (1 + rows.row(0).size())};
    std::vector<RowBytes> plain;
    plain.reserve(count);
    for (int y = 0; y < rows.rows(); ++y)
        plain.push_back(rows.row(y));
    const PixelHuffman codes(plain);
    if (isNoise(rows, codes, band.plainBytes)) {
        constexpr std::array<std::uint8_t, 1> kNoFilter = {0};
        for (const RowBytes row : plain)
            band.checksum = adlerOf(adlerOf(band.checksum, kNoFilter), row);
        codes.pack(band.packed);
        band.packedChecksum = checksumOf(band.packed);
        return band;
    }
    RowFilter filter(rows);
    Deflater deflater;
    for (int y = 0; y < rows.rows(); ++y) {
        const RowBytes row = filter.filtered(y);
        band.checksum = adlerOf(band.checksum, row);
        deflater.add(row);
    }
    band.packed = deflater.takeFlushed();
    band.packed.squeeze();
    band.packedChecksum = checksumOf(band.packed);
    return band;
}

PngBand PngFile::band(std::size_t index) const
{
    const StoredBand& from = stored[index];
    PngBand band = from.band;
    band.packed = bytes.sliced(from.at, from.count);
    return band;
}

PngFile pngOf(int width, int height, std::span<const PngBand> bands)
{
    std::array<char, 13> header{}; // After the sides: 16 bits, RGBA, the only packing and filters, not interlaced.
    qToBigEndian(static_cast<quint32>(width), header.data());
    qToBigEndian(static_cast<quint32>(height), header.data() + 4);
    header[8] = 16;
    header[9] = 6;
    std::array<char, 9> dots{};
    qToBigEndian(kDotsAMetre, dots.data());
    qToBigEndian(kDotsAMetre, dots.data() + 4);
    dots[8] = 1; // A metre.

    qsizetype packedBytes = 0;
    std::uint32_t checksum = 1;
    for (const PngBand& band : bands) {
        packedBytes += band.packed.size() + 12;
        checksum =
            static_cast<std::uint32_t>(adler32_combine(checksum, band.checksum, static_cast<z_off_t>(band.plainBytes)));
    }
    // zlib's header, and what ends its stream: an empty last block and the checksum.
    constexpr std::array<char, 2> kBegin = {'\x78', '\x01'};
    std::array<char, 6> end = {'\x03', '\x00'};
    qToBigEndian(checksum, end.data() + 2);

    PngFile png;
    png.bytes.reserve(packedBytes + 128);
    png.stored.reserve(bands.size());
    addPlain(png, QByteArrayView("\x89PNG\r\n\x1a\n", 8));
    addChunk(png, "IHDR", {QByteArrayView(header)});
    addChunk(png, "pHYs", {QByteArrayView(dots)});
    for (const PngBand& band : bands) {
        const QByteArrayView before = &band == &bands.front() ? QByteArrayView(kBegin) : QByteArrayView();
        const QByteArrayView after = &band == &bands.back() ? QByteArrayView(end) : QByteArrayView();
        PngFile::StoredBand kept{.band = band, .at = png.bytes.size() + 8 + before.size(), .count = band.packed.size()};
        kept.band.packed.clear();
        png.stored.push_back(std::move(kept));
        addChunk(png, "IDAT", {before, {band.packed, band.packedChecksum}, after});
    }
    addChunk(png, "IEND", {});
    return png;
}

} // namespace hairpaint::model
