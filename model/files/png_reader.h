// Reads PNG files of our own without libpng, which would print lines of its own about broken ones: chunks (PNG
// specification, section 5), then the pixels row by row (sections 9 and 10). Interlaced and palette images are not
// read. Any thread.
#pragma once

#include <QByteArray>
#include <QByteArrayView>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

namespace hairpaint::model {

/// The parts of a PNG whose structure and checksums were found good.
struct PngParts
{
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    int depth = 0;      ///< Bits a channel.
    int colourType = 0; ///< 2 RGB, 6 RGBA, ...
    bool interlaced = false;
    /// Of the bytes given, the chunks from the first IDAT to the last; theirs together are one zlib stream.
    QByteArrayView pixelChunks;
    bool onlyPixelsAndDpi = true; ///< No chunk was left out but pHYs, which says the resolution.
    std::uint32_t checksum = 0;   ///< CRC-32 of all bytes.
};

/// None where anything about the chunks is wrong. Allocates nothing.
[[nodiscard]] std::optional<PngParts> readPngParts(const QByteArray& png);

/// What its first chunk says, without pixels; none where that chunk is broken.
[[nodiscard]] std::optional<PngParts> readPngHeader(const QByteArray& png);

/// The pixels' chunks of a damaged one, up to the first chunk that is broken; one that the end cuts off belongs to
/// them. Empty where there is none.
[[nodiscard]] QByteArrayView pixelChunksOf(const QByteArray& png);

/// Inflates and unfilters one row after another. Throws std::bad_alloc where zlib finds no memory. Holds two rows and
/// zlib's window, however large the image is.
class PngRows
{
public:
    /// `pixelBytes`: 3, 4, 6 or 8. What `pixelChunks` shows must outlive this.
    PngRows(QByteArrayView pixelChunks, std::size_t rowBytes, int pixelBytes);
    ~PngRows();
    PngRows(const PngRows&) = delete;
    PngRows& operator=(const PngRows&) = delete;

    /// The next row, good until the next call; empty where the stream is broken or too short.
    [[nodiscard]] std::span<const std::uint8_t> next();
    /// After the last row: true where the stream ends there and its checksum is right.
    [[nodiscard]] bool atEnd();

private:
    struct Stream;
    std::unique_ptr<Stream> m_stream;
};

} // namespace hairpaint::model
