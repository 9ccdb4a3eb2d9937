// Writes PNG files of 16-bit RGBA: bands of rows, each packed alone, so that several threads can pack one image and a
// band that has not changed keeps its bytes. Any thread. Throws std::bad_alloc where memory runs out.
#pragma once

#include <QByteArray>

#include <cstdint>
#include <span>
#include <vector>

namespace hairpaint::model {

/// Rows of an image, to be filled before they are packed.
class PngRowBuffer
{
public:
    PngRowBuffer(int width, int rows);

    [[nodiscard]] int rows() const { return m_rows; }
    /// 8 bytes a pixel, big-endian: red, green, blue, alpha.
    [[nodiscard]] std::span<std::uint8_t> row(int y);
    [[nodiscard]] std::span<const std::uint8_t> row(int y) const;

private:
    std::size_t m_rowBytes;
    int m_rows;
    std::vector<std::uint8_t> m_bytes; ///< A pixel of zeros before each row, to its left.
};

/// Rows as a piece of a deflate stream that refers to no other piece and ends on a whole byte.
struct PngBand
{
    QByteArray packed;
    std::uint32_t packedChecksum = 0; ///< CRC-32 of `packed`.
    std::uint32_t checksum = 0;       ///< Adler-32 of the rows with the numbers of their filters.
    std::size_t plainBytes = 0;       ///< Size of those rows, filter numbers included.
};
[[nodiscard]] PngBand packBand(const PngRowBuffer& rows);

/// A file, and what is known of it for the next one, in which most is the same.
struct PngFile
{
    QByteArray bytes;
    std::uint32_t checksum = 0; ///< CRC-32 of all bytes.
    /// The file's bands, with `packed` left out: it lies in `bytes` at `at`, `count` bytes. Empty where the file was
    /// read.
    struct StoredBand
    {
        PngBand band;
        qsizetype at = 0;
        qsizetype count = 0;
    };
    std::vector<StoredBand> stored;

    [[nodiscard]] PngBand band(std::size_t index) const;
};

/// An image of 72 dots an inch from its bands, the top one first.
[[nodiscard]] PngFile pngOf(int width, int height, std::span<const PngBand> bands);

} // namespace hairpaint::model
