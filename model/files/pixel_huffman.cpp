// Counting, codes and bits.
#include "model/files/pixel_huffman.h"

#include <QtEndian>

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

namespace hairpaint::model {

namespace {

constexpr std::size_t kBytesAPixel = 8;
constexpr std::size_t kEndOfBlock = 256;
constexpr std::size_t kFourAgain = 258;    ///< Symbol that repeats 4 bytes.
constexpr std::uint32_t kLongestCode = 15; ///< Bits.
/// The second of two distance codes of one bit, 0 and 1: copies from 2 bytes before.
constexpr std::uint32_t kDistanceCode = 1;
constexpr std::uint32_t kCodeLengthCodes = 19;
constexpr std::size_t kHeaderBits = 3 + 5 + 5 + 4 + 3 * kCodeLengthCodes;

/// The same value in red, green and blue.
bool isGrey(const std::uint8_t* pixel)
{
    const auto words = qFromBigEndian<quint64>(pixel);
    return ((words >> 16U) & 0xFFFFFFFFU) == words >> 32U;
}

std::uint32_t reversed(std::uint32_t bits, std::uint32_t length)
{
    std::uint32_t turned = 0;
    for (std::uint32_t i = 0; i < length; ++i)
        turned |= ((bits >> i) & 1U) << (length - 1 - i);
    return turned;
}

/// The depth of each symbol in Huffman's tree over its counts; 0 where it never occurs.
std::vector<std::uint32_t> depthsOf(std::span<const std::uint32_t> counts)
{
    using Weighted =
        std::pair<std::uint64_t, std::size_t>; // Equal weights by number, so that the tree is always the same.
    std::priority_queue<Weighted, std::vector<Weighted>, std::greater<>> open;
    std::vector<std::size_t> parents(counts.size(), 0);
    for (std::size_t symbol = 0; symbol < counts.size(); ++symbol)
        if (counts[symbol] > 0)
            open.emplace(counts[symbol], symbol);
    while (open.size() > 1) {
        const Weighted first = open.top();
        open.pop();
        const Weighted second = open.top();
        open.pop();
        parents[first.second] = parents[second.second] = parents.size();
        open.emplace(first.first + second.first, parents.size());
        parents.push_back(0);
    }
    std::vector<std::uint32_t> depths(parents.size(), 0);
    for (std::size_t node = parents.size(); node-- > 0;)
        if (parents[node] != 0)
            depths[node] = depths[parents[node]] + 1;
    depths.resize(counts.size());
    return depths;
}

/// Bits into bytes, the first one lowest.
class BitWriter
{
public:
    /// `target`: 8 bytes longer than what is written.
    explicit BitWriter(char* target) : m_at(target) {}

    /// At most 57 bits between two calls of `flush`.
    void put(std::uint64_t bits, std::uint32_t length)
    {
        m_bits |= bits << m_count;
        m_count += length;
    }
    void flush()
    {
        qToLittleEndian<quint64>(m_bits, m_at);
        m_at += m_count / 8;
        m_bits >>= m_count / 8 * 8;
        m_count %= 8;
    }
    /// Fills the last byte with zeros; where it ends.
    [[nodiscard]] char* end()
    {
        m_count = (m_count + 7) / 8 * 8;
        flush();
        return m_at;
    }

private:
    char* m_at;
    std::uint64_t m_bits = 0;
    std::uint32_t m_count = 0; ///< Below 8 after `flush`.
};

} // namespace

PixelHuffman::PixelHuffman(std::vector<std::span<const std::uint8_t>> rows) : m_rows(std::move(rows))
{
    for (const std::span<const std::uint8_t> row : m_rows) {
        ++m_counts[0]; // The filter's number.
        for (std::size_t at = 0; at < row.size(); at += kBytesAPixel) {
            const std::uint8_t* pixel = row.data() + at;
            ++m_counts[pixel[0]];
            ++m_counts[pixel[1]];
            if (isGrey(pixel))
                ++m_counts[kFourAgain];
            else
                for (std::size_t i = 2; i < 6; ++i)
                    ++m_counts[pixel[i]];
            ++m_counts[pixel[6]];
            ++m_counts[pixel[7]];
        }
    }
    m_counts[kEndOfBlock] = 1;
    giveCodes();
}

void PixelHuffman::giveCodes()
{
    std::array<std::uint32_t, kSymbols> counts = m_counts;
    std::vector<std::uint32_t> lengths = depthsOf(counts);
    // Rare symbols lie too deep at times; nearer counts lift them (as bzip2 does it).
    while (std::ranges::max(lengths) > kLongestCode) {
        for (std::uint32_t& count : counts)
            count = (count + 1) / 2;
        lengths = depthsOf(counts);
    }
    std::uint32_t next = 0;
    for (std::uint32_t length = 1; length <= kLongestCode; ++length) {
        next *= 2;
        for (std::size_t symbol = 0; symbol < kSymbols; ++symbol)
            if (lengths[symbol] == length)
                m_codes[symbol] = {.bits = reversed(next++, length), .length = length};
    }
}

std::size_t PixelHuffman::packedBytes() const
{
    std::size_t bits = kHeaderBits + 4 * (kSymbols + 2) + m_counts[kFourAgain];
    for (std::size_t symbol = 0; symbol < kSymbols; ++symbol)
        bits += std::size_t{m_counts[symbol]} * m_codes[symbol].length;
    return (bits + 3 + 7) / 8 + 4;
}

void PixelHuffman::pack(QByteArray& target) const
{
    const qsizetype before = target.size();
    const auto packed = static_cast<qsizetype>(packedBytes());
    target.resize(before + packed + 8);
    BitWriter writer(target.data() + before);

    writer.put(0b100, 3);                // Not the last block; codes of its own.
    writer.put(kSymbols - 257, 5);       // Symbols beyond the end of the block.
    writer.put(1, 5);                    // Two distances.
    writer.put(kCodeLengthCodes - 4, 4); // The lengths' own codes: 4 bits for 0 to 15, none for the three that repeat.
    for (std::uint32_t i = 0; i < kCodeLengthCodes; ++i) {
        writer.put(i < 3 ? 0 : 4, 3);
        writer.flush();
    }
    for (const Code& code : m_codes) {
        writer.put(reversed(code.length, 4), 4);
        writer.flush();
    }
    writer.put(reversed(1, 4), 4);
    writer.put(reversed(1, 4), 4);
    writer.flush();

    const auto put = [&writer](const Code& code) { writer.put(code.bits, code.length); };
    // The distance's bit follows.
    const Code again{.bits = m_codes[kFourAgain].bits | (kDistanceCode << m_codes[kFourAgain].length),
                     .length = m_codes[kFourAgain].length + 1};
    for (const std::span<const std::uint8_t> row : m_rows) {
        put(m_codes[0]);
        writer.flush();
        for (std::size_t at = 0; at < row.size(); at += kBytesAPixel) {
            const std::uint8_t* pixel = row.data() + at;
            put(m_codes[pixel[0]]);
            put(m_codes[pixel[1]]);
            if (isGrey(pixel)) {
                put(again);
            } else {
                put(m_codes[pixel[2]]);
                writer.flush();
                put(m_codes[pixel[3]]);
                put(m_codes[pixel[4]]);
                put(m_codes[pixel[5]]);
            }
            writer.flush();
            put(m_codes[pixel[6]]);
            put(m_codes[pixel[7]]);
            writer.flush();
        }
    }
    put(m_codes[kEndOfBlock]);
    writer.put(0, 3); // An empty stored block: its length, and the same inverted.
    char* end = writer.end();
    constexpr std::array<char, 4> kNoBytes = {'\0', '\0', '\xFF', '\xFF'};
    std::ranges::copy(kNoBytes, end);
    target.truncate(before + packed);
}

} // namespace hairpaint::model
