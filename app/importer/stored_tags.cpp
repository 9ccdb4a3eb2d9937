// Headers byte by byte.
#include "app/importer/stored_tags.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <string_view>

namespace hairpaint::importer {

namespace {

constexpr std::size_t kMostEntries = 4096; ///< Limit on the entries of a TIFF directory and on a PSD's resources.
constexpr std::uint64_t kMostExifBytes = 1U << 20U;

enum TiffTag : std::uint16_t
{
    BitsPerSample = 258,
    Photometric = 262,
    Orientation = 274,
    ExtraSamples = 338
};

/// Numbers of a file in either order of bytes; what lies beyond its end is 0, and it is broken from there on.
class FileBytes
{
public:
    explicit FileBytes(std::istream& file) : m_file(file) {}

    [[nodiscard]] std::uint64_t number(std::uint64_t at, int bytes, bool isBigEndian)
    {
        std::array<std::uint8_t, 8> read{};
        if (!take(at, read.data(), static_cast<std::size_t>(bytes)))
            return 0;
        std::uint64_t value = 0;
        for (int i = 0; i < bytes; ++i)
            value = value << 8U | read[static_cast<std::size_t>(isBigEndian ? i : bytes - 1 - i)];
        return value;
    }
    [[nodiscard]] bool startsWith(std::string_view start, std::uint64_t at = 0)
    {
        std::array<std::uint8_t, 8> read{};
        return take(at, read.data(), start.size()) && std::memcmp(read.data(), start.data(), start.size()) == 0;
    }
    [[nodiscard]] std::vector<std::uint8_t> part(std::uint64_t at, std::uint64_t count)
    {
        std::vector<std::uint8_t> read(static_cast<std::size_t>(count));
        if (!take(at, read.data(), read.size()))
            read.clear();
        return read;
    }
    [[nodiscard]] std::uint64_t size()
    {
        m_file.clear();
        m_file.seekg(0, std::ios::end);
        const auto end = static_cast<std::streamoff>(m_file.tellg());
        return end < 0 ? 0 : static_cast<std::uint64_t>(end);
    }
    [[nodiscard]] bool isBroken() const { return m_isBroken; }

private:
    bool take(std::uint64_t at, std::uint8_t* bytes, std::size_t count)
    {
        constexpr std::uint64_t kFurthest = std::uint64_t{1} << 40U;
        m_file.clear();
        if (at > kFurthest || !m_file.seekg(static_cast<std::streamoff>(at)) ||
            !m_file.read(reinterpret_cast<char*>(bytes), static_cast<std::streamsize>(count)))
            m_isBroken = true;
        return !m_isBroken;
    }

    std::istream& m_file;
    bool m_isBroken = false;
};

/// The first directory of a TIFF (42) or BigTIFF (43): calls `visit(tag, first value)` for tags of short and long
/// values. Returns where the directory lies; 0 where there is none.
std::uint64_t visitTiff(FileBytes& bytes, std::uint64_t begin,
                        const std::function<void(std::uint16_t, std::uint64_t)>& visit)
{
    const bool isBigEndian = bytes.startsWith("MM", begin);
    if (!isBigEndian && !bytes.startsWith("II", begin))
        return 0;
    const auto number = [&](std::uint64_t at, int count) { return bytes.number(begin + at, count, isBigEndian); };
    const std::uint64_t version = number(2, 2);
    if (version != 42 && version != 43)
        return 0;
    const bool isBig = version == 43;
    const std::uint64_t directory = isBig ? number(8, 8) : number(4, 4);
    const std::uint64_t count = isBig ? number(directory, 8) : number(directory, 2);
    if (directory == 0 || bytes.isBroken() || count > kMostEntries)
        return 0;
    const int wide = isBig ? 8 : 4;
    for (std::uint64_t i = 0; i < count && !bytes.isBroken(); ++i) {
        const std::uint64_t entry = directory + (isBig ? 8 + 20 * i : 2 + 12 * i);
        const auto tag = static_cast<std::uint16_t>(number(entry, 2));
        const std::uint64_t type = number(entry + 2, 2);
        constexpr std::uint64_t kShort = 3;
        constexpr std::uint64_t kLong = 4;
        if (type != kShort && type != kLong)
            continue;
        const int each = type == kShort ? 2 : 4;
        const std::uint64_t values = number(entry + 4, wide);
        const std::uint64_t at = entry + 4 + static_cast<std::uint64_t>(wide);
        const bool isInside = values <= static_cast<std::uint64_t>(wide / each);
        visit(tag, values == 0 ? 0 : number(isInside ? at : number(at, wide), each));
    }
    return bytes.isBroken() ? 0 : directory;
}

void readTiff(FileBytes& bytes, StoredTags& tags)
{
    constexpr std::uint64_t kNoAlpha = 0;
    constexpr std::uint64_t kAssociated = 1;
    bool hasBits = false;
    std::uint64_t photometric = 1;
    const std::uint64_t directory = visitTiff(bytes, 0, [&](std::uint16_t tag, std::uint64_t value) {
        hasBits = hasBits || tag == BitsPerSample;
        if (tag == Photometric) {
            photometric = value;
        } else if (tag == ExtraSamples) {
            tags.isAssociated = value == kAssociated;
            tags.fourthIsNoAlpha = value == kNoAlpha;
        }
    });
    if (directory == 0) {
        tags = {};
        return;
    }
    tags.lacksBitsPerSample = !hasBits;
    tags.lowIsWhite = photometric == 0;
}

/// Only a header that has a mask of alpha gives the fourth byte a meaning.
void readBmp(FileBytes& bytes, StoredTags& tags)
{
    constexpr std::uint64_t kWithAlphaMask = 56;
    constexpr std::uint64_t kBitFields = 3;
    constexpr std::uint64_t kAlphaBitFields = 6;
    const std::uint64_t header = bytes.number(14, 4, false);
    const std::uint64_t bits = bytes.number(28, 2, false);
    const std::uint64_t compression = bytes.number(30, 4, false);
    const bool hasMask = header >= kWithAlphaMask && (compression == kBitFields || compression == kAlphaBitFields) &&
                         bytes.number(66, 4, false) != 0;
    tags.fourthIsNoAlpha = bits == 32 && !hasMask && !bytes.isBroken();
}

/// The header tells how many bits of alpha there are; the extension area of TGA 2.0, what they mean.
void readTga(FileBytes& bytes, StoredTags& tags)
{
    constexpr std::uint64_t kFooter = 26;
    constexpr std::uint64_t kRgb = 2;
    constexpr std::uint64_t kPackedRgb = 10;
    const std::uint64_t type = bytes.number(2, 1, false);
    const bool isRgb32 =
        bytes.number(1, 1, false) == 0 && (type == kRgb || type == kPackedRgb) && bytes.number(16, 1, false) == 32;
    if (!isRgb32)
        return;
    tags.fourthIsNoAlpha = (bytes.number(17, 1, false) & 0xFU) == 0;
    const std::uint64_t size = bytes.size();
    if (size < kFooter + 18 || !bytes.startsWith("TRUEVISI", size - 18))
        return;
    const std::uint64_t extension = bytes.number(size - kFooter, 4, false);
    if (extension == 0 || extension + 495 > size)
        return;
    const std::uint64_t attributes = bytes.number(extension + 494, 1, false);
    constexpr std::uint64_t kPremultiplied = 4;
    if (bytes.isBroken())
        return;
    tags.isAssociated = attributes == kPremultiplied;
    tags.fourthIsNoAlpha = attributes < 3;
}

void readPsd(FileBytes& bytes, StoredTags& tags)
{
    constexpr std::uint64_t kHeader = 26;
    constexpr std::uint64_t kVersionInfo = 1057;
    constexpr std::uint64_t kCmyk = 4;
    tags.hasInks = bytes.number(24, 2, true) == kCmyk;
    const std::uint64_t resources = kHeader + 4 + bytes.number(kHeader, 4, true);
    const std::uint64_t end = resources + 4 + bytes.number(resources, 4, true);
    std::uint64_t at = resources + 4;
    for (std::size_t i = 0; i < kMostEntries && at + 12 <= end && !bytes.isBroken(); ++i) {
        const std::uint64_t id = bytes.number(at + 4, 2, true);
        const std::uint64_t name = bytes.number(at + 6, 1, true);
        const std::uint64_t lengthAt = at + 6 + (name + 2) / 2 * 2; // Its length byte and its letters, padded to even.
        const std::uint64_t length = bytes.number(lengthAt, 4, true);
        if (id == kVersionInfo && length >= 5) {
            tags.lacksMergedPicture = bytes.number(lengthAt + 8, 1, true) == 0 && !bytes.isBroken();
            return;
        }
        at = lengthAt + 4 + (length + 1) / 2 * 2;
    }
}

void readPng(FileBytes& bytes, StoredTags& tags)
{
    std::uint64_t at = 8;
    while (!bytes.isBroken()) {
        const std::uint64_t length = bytes.number(at, 4, true);
        if (bytes.startsWith("IEND", at + 4))
            return;
        if (bytes.startsWith("eXIf", at + 4) && length <= kMostExifBytes)
            tags.orientation = exifOrientation(bytes.part(at + 8, length));
        at += 12 + length;
    }
}

class MemoryBuffer : public std::streambuf
{
public:
    explicit MemoryBuffer(const std::vector<std::uint8_t>& bytes)
    {
        char* begin = const_cast<char*>(reinterpret_cast<const char*>(bytes.data())); // It is only read.
        setg(begin, begin, begin + bytes.size());
    }

protected:
    pos_type seekoff(off_type offset, std::ios::seekdir from, std::ios::openmode /*mode*/) override
    {
        const off_type base = from == std::ios::beg ? 0 : from == std::ios::end ? egptr() - eback() : gptr() - eback();
        return seekpos(base + offset, std::ios::in);
    }
    pos_type seekpos(pos_type position, std::ios::openmode /*mode*/) override
    {
        const auto at = static_cast<off_type>(position);
        if (at < 0 || at > egptr() - eback())
            return pos_type(off_type(-1));
        setg(eback(), eback() + at, egptr());
        return position;
    }
};

} // namespace

StoredTags readStoredTags(std::istream& file)
{
    FileBytes bytes(file);
    StoredTags tags;
    if (bytes.startsWith("II") || bytes.startsWith("MM"))
        readTiff(bytes, tags);
    else if (bytes.startsWith("BM"))
        readBmp(bytes, tags);
    else if (bytes.startsWith("8BPS"))
        readPsd(bytes, tags);
    else if (bytes.startsWith("\x89PNG"))
        readPng(bytes, tags);
    else
        readTga(bytes, tags);
    return tags;
}

int exifOrientation(const std::vector<std::uint8_t>& exif)
{
    MemoryBuffer buffer(exif);
    std::istream stream(&buffer);
    FileBytes bytes(stream);
    const bool isMarked = bytes.startsWith("Exif");
    int orientation = 0;
    FileBytes again(stream);
    (void)visitTiff(again, isMarked ? 6 : 0, [&orientation](std::uint16_t tag, std::uint64_t value) {
        if (tag == Orientation && value >= 1 && value <= 8)
            orientation = static_cast<int>(value);
    });
    return orientation;
}

std::optional<std::vector<std::uint8_t>> withBitsPerSample(std::vector<std::uint8_t> tiff)
{
    MemoryBuffer buffer(tiff);
    std::istream stream(&buffer);
    FileBytes bytes(stream);
    bool hasBits = false;
    const std::uint64_t directory = visitTiff(
        bytes, 0, [&hasBits](std::uint16_t tag, std::uint64_t) { hasBits = hasBits || tag == BitsPerSample; });
    const bool isBigEndian = tiff.size() > 2 && tiff[0] == 'M';
    if (directory == 0 || hasBits || bytes.number(2, 2, isBigEndian) != 42 || tiff.size() > 0x7FFF'FFFFU)
        return std::nullopt;
    const auto count = static_cast<std::size_t>(bytes.number(directory, 2, isBigEndian));
    const std::vector<std::uint8_t> entries = bytes.part(directory + 2, 12 * count);
    const std::vector<std::uint8_t> next = bytes.part(directory + 2 + 12 * count, 4);
    if (bytes.isBroken() || count == kMostEntries)
        return std::nullopt;
    const auto put = [&](std::uint64_t value, int size, auto&& take) {
        for (int i = 0; i < size; ++i)
            take(i, static_cast<std::uint8_t>(value >> 8U * static_cast<unsigned>(isBigEndian ? size - 1 - i : i)));
    };
    if (tiff.size() % 2 != 0)
        tiff.push_back(0);
    const std::size_t moved = tiff.size();
    const auto append = [&](std::uint64_t value, int size) {
        put(value, size, [&tiff](int, std::uint8_t byte) { tiff.push_back(byte); });
    };
    append(count + 1, 2);
    std::size_t before = 0; // Entries stand in the order of their tags.
    const auto tagOf = [&](std::size_t i) {
        return isBigEndian ? entries[12 * i] << 8U | entries[12 * i + 1] : entries[12 * i + 1] << 8U | entries[12 * i];
    };
    while (before < count && tagOf(before) < BitsPerSample)
        ++before;
    const auto split = entries.begin() + static_cast<std::ptrdiff_t>(12 * before);
    tiff.insert(tiff.end(), entries.begin(), split);
    append(BitsPerSample, 2);
    append(3, 2); // Type: 16-bit integer.
    append(1, 4); // Number of values.
    append(1, 2); // The value: 1 bit.
    append(0, 2);
    tiff.insert(tiff.end(), split, entries.end());
    tiff.insert(tiff.end(), next.begin(), next.end());
    put(moved, 4, [&tiff](int i, std::uint8_t byte) { tiff[4 + static_cast<std::size_t>(i)] = byte; });
    return tiff;
}

} // namespace hairpaint::importer
