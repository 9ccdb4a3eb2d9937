// Deflate (RFC 1951) for 16-bit RGBA pixels that are noise, in which zlib looks long for repetitions and finds none but
// that red, green and blue are equal. One block of Huffman codes for rows without a filter. Any thread.
#pragma once

#include <QByteArray>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace hairpaint::model {

class PixelHuffman
{
public:
    /// Rows as PNG has them: 8 bytes a pixel. They must outlive this.
    explicit PixelHuffman(std::vector<std::span<const std::uint8_t>> rows);

    /// The number of bytes that pack() would append.
    [[nodiscard]] std::size_t packedBytes() const;
    /// Appends a block that isn't the last one, and the empty stored block that ends it on a whole byte.
    void pack(QByteArray& target) const;

private:
    static constexpr std::size_t kSymbols = 259; ///< 256 bytes, the end of the block, and repetitions of 3 and 4 bytes.

    struct Code
    {
        std::uint32_t bits = 0; ///< The code's bits, the first one lowest.
        std::uint32_t length = 0;
    };
    void giveCodes();

    std::vector<std::span<const std::uint8_t>> m_rows;
    std::array<std::uint32_t, kSymbols> m_counts{};
    std::array<Code, kSymbols> m_codes{};
};

} // namespace hairpaint::model
