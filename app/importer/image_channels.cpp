// Channels by name, rows in pieces.
#include "app/importer/image_channels.h"

#include "model/values/srgb.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace hairpaint::importer {

namespace {

constexpr std::size_t kPieceBytes = std::size_t{1} << 24U;

std::string lowered(std::string_view text)
{
    std::string low(text);
    std::ranges::transform(low, low.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return low;
}

/// The number of the channel of that name, which may be spelled out; -1 where there is none.
int channelNamed(std::span<const std::string> names, const std::string& layer, std::string_view letter,
                 std::string_view word)
{
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string name = lowered(names[i]);
        if (name == layer + std::string(letter) || name == layer + std::string(word))
            return static_cast<int>(i);
    }
    return -1;
}

/// Red, green and blue of a layer; none where it lacks one.
std::vector<int> coloursOf(std::span<const std::string> names, const std::string& layer)
{
    std::vector<int> colours{channelNamed(names, layer, "r", "red"), channelNamed(names, layer, "g", "green"),
                             channelNamed(names, layer, "b", "blue")};
    if (std::ranges::any_of(colours, [](int channel) { return channel < 0; }))
        colours.clear();
    return colours;
}

/// The rows [y0, y1) of channels [first, first + count).
template<typename Sample>
bool readPiece(OIIO::ImageInput& input, int y0, int y1, int first, int count, OIIO::TypeDesc type, Sample* samples)
{
    const OIIO::ImageSpec& spec = input.spec();
    if (spec.tile_width > 0)
        return input.read_tiles(0, 0, spec.x, spec.x + spec.width, spec.y + y0, spec.y + y1, spec.z, spec.z + 1, first,
                                first + count, type, samples);
    return input.read_scanlines(0, 0, spec.y + y0, spec.y + y1, spec.z, first, first + count, type, samples);
}

/// visit(y, row) for each row, of `range` samples a pixel.
template<typename Sample, typename Visit>
bool readRows(OIIO::ImageInput& input, int first, int range, OIIO::TypeDesc type, const Visit& visit)
{
    const OIIO::ImageSpec& spec = input.spec();
    const std::size_t rowSamples = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(range);
    int rows = static_cast<int>(std::clamp<std::size_t>(kPieceBytes / (rowSamples * sizeof(Sample)), 1, 1024));
    if (spec.tile_width > 0) // Whole tiles.
        rows = std::max(rows / std::max(spec.tile_height, 1), 1) * std::max(spec.tile_height, 1);
    rows = std::min(rows, spec.height);
    std::vector<Sample> samples(rowSamples * static_cast<std::size_t>(rows));
    for (int y0 = 0; y0 < spec.height; y0 += rows) {
        const int y1 = std::min(y0 + rows, spec.height);
        if (!readPiece(input, y0, y1, first, range, type, samples.data()))
            return false;
        for (int y = y0; y < y1; ++y)
            visit(y, samples.data() + static_cast<std::size_t>(y - y0) * rowSamples);
    }
    return true;
}

/// Where data lies in the picture that is made of it.
struct Window
{
    int left = 0, top = 0, width = 0, height = 0;
    bool isCovered = true; ///< By the data, all of it.
};

Window windowOf(const OIIO::ImageSpec& spec, bool isShown)
{
    if (!isShown || spec.full_width <= 0 || spec.full_height <= 0)
        return {.width = spec.width, .height = spec.height};
    Window window{.left = spec.x - spec.full_x,
                  .top = spec.y - spec.full_y,
                  .width = spec.full_width,
                  .height = spec.full_height};
    window.isCovered = window.left <= 0 && window.top <= 0 && window.left + spec.width >= window.width &&
                       window.top + spec.height >= window.height;
    return window;
}

std::uint16_t asSample(float value)
{
    return value > 0.0F ? static_cast<std::uint16_t>(std::min(value, 1.0F) * 65535.0F + 0.5F) : std::uint16_t{0};
}

/// Colours and alpha of one pixel, of floats.
void putPixel(const float* pixel, int first, const SampleReading& reading, bool hasCoverage, std::uint16_t* out)
{
    const ImageChannels& channels = reading.channels;
    const float alpha = channels.alpha < 0 ? 1.0F : pixel[channels.alpha - first];
    const bool divides = reading.isAssociated && channels.alpha >= 0 && alpha > 0.0F;
    for (const int channel : channels.colours) {
        float value = pixel[channel - first];
        if (divides)
            value /= alpha;
        if (reading.isLinear)
            value = value > 0.0F ? model::srgbFromLinear(std::min(value, 1.0F)) : 0.0F;
        *out++ = asSample(value);
    }
    if (hasCoverage)
        *out = asSample(alpha);
}

} // namespace

ImageChannels channelsOf(const OIIO::ImageSpec& spec, const StoredTags& tags)
{
    const std::span<const std::string> names(spec.channelnames);
    const int alpha = tags.fourthIsNoAlpha ? -1 : spec.alpha_channel;
    ImageChannels channels{.colours = coloursOf(names, {}), .alpha = alpha};
    if (!channels.colours.empty())
        return channels;
    if (const int grey = channelNamed(names, {}, "y", "luminance"); grey >= 0)
        return {.colours = {grey}, .alpha = alpha};
    for (const std::string& name : names) {
        const std::string low = lowered(name);
        const std::size_t dot = low.rfind('.');
        if (dot == std::string::npos)
            continue;
        const std::string layer = low.substr(0, dot + 1);
        channels.colours = coloursOf(names, layer);
        if (!channels.colours.empty()) {
            channels.alpha = channelNamed(names, layer, "a", "alpha");
            return channels;
        }
    }
    // By their order: as many as there are before what is alpha.
    std::vector<int> others;
    for (int i = 0; i < spec.nchannels; ++i)
        if (i != spec.alpha_channel)
            others.push_back(i);
    if (others.empty())
        return {.colours = {0}, .alpha = -1};
    others.resize(others.size() >= 3 ? 3 : 1);
    return {.colours = others, .alpha = alpha};
}

tl::expected<wire::Image, wire::Reason> readSamples(OIIO::ImageInput& input, const SampleReading& reading)
{
    const OIIO::ImageSpec spec = input.spec();
    const Window window = windowOf(spec, reading.isShown);
    const ImageChannels& channels = reading.channels;
    const bool hasCoverage = channels.alpha >= 0 || !window.isCovered;
    const std::size_t count = channels.colours.size() + (hasCoverage ? 1 : 0);
    if (window.width <= 0 || window.height <= 0 || spec.width <= 0 || spec.height <= 0 ||
        !wire::imageFits(static_cast<std::uint64_t>(spec.width), static_cast<std::uint64_t>(spec.height), count) ||
        !wire::imageFits(static_cast<std::uint64_t>(window.width), static_cast<std::uint64_t>(window.height), count))
        return tl::unexpected(wire::Reason::TooLarge);
    wire::Image image{.width = static_cast<std::uint32_t>(window.width),
                      .height = static_cast<std::uint32_t>(window.height),
                      .channels = static_cast<std::uint32_t>(count),
                      .samples = std::vector<std::uint16_t>(static_cast<std::size_t>(window.width) *
                                                            static_cast<std::size_t>(window.height) * count)};
    std::vector<int> all = channels.colours;
    if (channels.alpha >= 0)
        all.push_back(channels.alpha);
    const auto [least, greatest] = std::ranges::minmax(all);
    const int first = least;
    const int range = greatest - least + 1;
    const int from = std::max(0, -window.left);
    const int until = std::min(spec.width, window.width - window.left);
    const auto rowOf = [&](int y) {
        return image.samples.data() +
               (static_cast<std::size_t>(y + window.top) * image.width + static_cast<std::size_t>(from + window.left)) *
                   count;
    };
    const auto isOutside = [&](int y) { return y + window.top < 0 || y + window.top >= window.height; };
    bool isWhole = false;
    if (reading.isAssociated || reading.isLinear || reading.isShown) {
        isWhole = readRows<float>(input, first, range, OIIO::TypeDesc::FLOAT, [&](int y, const float* row) {
            if (isOutside(y))
                return;
            std::uint16_t* out = rowOf(y);
            for (int x = from; x < until; ++x, out += count)
                putPixel(row + std::size_t(x) * std::size_t(range), first, reading, hasCoverage, out);
        });
    } else {
        const auto keep = [&](int y, const auto* row, std::uint32_t spread) {
            std::uint16_t* out = rowOf(y);
            for (int x = from; x < until; ++x, row += range)
                for (const int channel : all)
                    *out++ = static_cast<std::uint16_t>(row[channel - first] * spread);
        };
        // The library converts 8 bits through floats, to the same values.
        constexpr std::uint32_t kSpread = 0xFFFFU / 0xFFU;
        if (spec.format == OIIO::TypeDesc::UINT8)
            isWhole = readRows<std::uint8_t>(input, first, range, OIIO::TypeDesc::UINT8,
                                             [&](int y, const std::uint8_t* row) { keep(y, row, kSpread); });
        else
            isWhole = readRows<std::uint16_t>(input, first, range, OIIO::TypeDesc::UINT16,
                                              [&](int y, const std::uint16_t* row) { keep(y, row, 1); });
    }
    if (!isWhole)
        return tl::unexpected(wire::Reason::Damaged);
    return image;
}

} // namespace hairpaint::importer
