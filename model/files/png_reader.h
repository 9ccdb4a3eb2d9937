// Reads PNG files of our own without libpng, which would print lines of its own about broken ones: chunks (PNG
// specification, section 5), then the pixels row by row (sections 9 and 10). Interlaced and palette images are not
// read. Any thread.
#pragma once

#include "model/files/png_bands.h"

#include <QByteArray>
#include <QByteArrayView>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace hairpaint::model {

/// The parts of a PNG whose structure and checksums were found good.
struct PngParts
{
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    int depth = 0;      ///< Bits a channel.
    int colourType = 0; ///< 0 grey, 2 RGB, 6 RGBA, ...
    bool interlaced = false;
    /// The chunks from the first IDAT to the last; the contents of the IDAT chunks together are one zlib stream.
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

/// Inflates and unfilters one row after another, an image of our own quicker than others. Throws std::bad_alloc where
/// there is no memory. Holds 64 rows at most, however large the image is. Where the stream is broken it gives the rows
/// before that offset.
class PngRows
{
public:
    /// `pixelBytes`: 2, 3, 4, 6 or 8. What `pixelChunks` shows must outlive this.
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
    [[nodiscard]] std::span<const std::uint8_t> nextOfBands();

    QByteArrayView m_chunks;
    std::size_t m_rowBytes;
    int m_pixelBytes;
    std::unique_ptr<PngBands> m_bands; ///< Null once the image is read as a stream.
    std::span<std::uint8_t> m_band;    ///< What is left of the present one.
    std::vector<std::uint8_t> m_above; ///< The row before, the filter's number first.
    std::unique_ptr<Stream> m_stream;  ///< Null before the first row.
    std::size_t m_given = 0;           ///< Rows delivered so far.
};

} // namespace hairpaint::model
