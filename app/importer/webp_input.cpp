// The picture by libwebp's decoder, the chunks beside it by its demultiplexer.
#include "app/importer/webp_input.h"

#include "app/importer/stored_tags.h"

#include <webp/decode.h>
#include <webp/demux.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>

namespace hairpaint::importer {

namespace {

std::vector<std::uint8_t> chunkOf(const WebPDemuxer* demuxer, const char* name)
{
    WebPChunkIterator chunk{};
    std::vector<std::uint8_t> bytes;
    if (WebPDemuxGetChunk(demuxer, name, 1, &chunk) != 0)
        bytes.assign(chunk.chunk.bytes, chunk.chunk.bytes + chunk.chunk.size);
    WebPDemuxReleaseChunkIterator(&chunk);
    return bytes;
}

} // namespace

std::optional<tl::expected<WebpImage, wire::Reason>> readWebp(const std::string& path)
{
    std::ifstream file(std::filesystem::path(std::u8string(path.begin(), path.end())), std::ios::binary);
    std::array<char, 12> start{};
    if (!file.read(start.data(), start.size()) || std::string_view(start.data(), 4) != "RIFF" ||
        std::string_view(start.data() + 8, 4) != "WEBP")
        return std::nullopt;
    file.seekg(0);
    const std::vector<char> read(std::istreambuf_iterator<char>(file), {});
    const auto* const bytes = reinterpret_cast<const std::uint8_t*>(read.data());
    WebPBitstreamFeatures features{};
    if (WebPGetFeatures(bytes, read.size(), &features) != VP8_STATUS_OK)
        return tl::unexpected(wire::Reason::Damaged);
    if (features.has_animation != 0)
        return std::nullopt;
    const bool hasAlpha = features.has_alpha != 0;
    WebpImage webp{.image = {.width = static_cast<std::uint32_t>(features.width),
                             .height = static_cast<std::uint32_t>(features.height),
                             .channels = hasAlpha ? 4U : 3U,
                             .samples = {}},
                   .profile = {}};
    wire::Image& image = webp.image;
    if (!wire::imageFits(image.width, image.height, image.channels))
        return tl::unexpected(wire::Reason::TooLarge);
    std::vector<std::uint8_t> samples(std::size_t{image.width} * image.height * image.channels);
    const int stride = features.width * static_cast<int>(image.channels);
    const auto* const decoded = hasAlpha
                                    ? WebPDecodeRGBAInto(bytes, read.size(), samples.data(), samples.size(), stride)
                                    : WebPDecodeRGBInto(bytes, read.size(), samples.data(), samples.size(), stride);
    if (decoded == nullptr)
        return tl::unexpected(wire::Reason::Damaged);
    constexpr unsigned kSpread = 0xFFFFU / 0xFFU;
    image.samples.resize(samples.size());
    std::ranges::transform(samples, image.samples.begin(),
                           [](std::uint8_t byte) { return static_cast<std::uint16_t>(kSpread * byte); });
    const WebPData data{.bytes = bytes, .size = read.size()};
    const std::unique_ptr<WebPDemuxer, decltype(&WebPDemuxDelete)> demuxer(WebPDemux(&data), WebPDemuxDelete);
    if (demuxer) {
        webp.profile = chunkOf(demuxer.get(), "ICCP");
        webp.orientation = exifOrientation(chunkOf(demuxer.get(), "EXIF"));
    }
    return webp;
}

} // namespace hairpaint::importer
