#include "app/importer/png_chunks.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string_view>

namespace hairpaint::importer {

namespace {

constexpr std::size_t kSignatureBytes = 8;
/// Bytes of a chunk besides its contents: their size, its name and its checksum.
constexpr std::size_t kBareBytes = 12;

std::size_t contentBytes(const std::vector<unsigned char>& png, std::size_t chunk)
{
    std::size_t bytes = 0;
    for (std::size_t i = 0; i < 4; ++i)
        bytes = bytes << 8U | png[chunk + i];
    return bytes;
}

} // namespace

void dropExif(std::vector<unsigned char>& png)
{
    constexpr std::string_view kExif = "eXIf";
    std::vector<unsigned char> kept;
    kept.reserve(png.size());
    std::size_t chunk = std::min(kSignatureBytes, png.size());
    std::copy_n(png.begin(), chunk, std::back_inserter(kept));
    while (chunk < png.size()) {
        const std::size_t left = png.size() - chunk;
        if (left < kBareBytes || contentBytes(png, chunk) > left - kBareBytes)
            return;
        const std::size_t bytes = kBareBytes + contentBytes(png, chunk);
        const auto begin = png.begin() + static_cast<std::ptrdiff_t>(chunk);
        if (!std::equal(kExif.begin(), kExif.end(), begin + 4))
            std::copy_n(begin, bytes, std::back_inserter(kept));
        chunk += bytes;
    }
    png = std::move(kept);
}

} // namespace hairpaint::importer
