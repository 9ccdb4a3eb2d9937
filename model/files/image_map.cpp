// Images to maps and back. Values are read from and written as encoded channels; nothing is linearised.
#include "model/files/image_map.h"

#include "model/files/image_resample.h"
#include "model/map_colours.h"

#include <QCoreApplication>

#include <algorithm>
#include <bit>
#include <cmath>

namespace hairpaint::model {

namespace {

constexpr float kGreatest = 65535.0F;

/// The pixel as red, green, blue, alpha.
sim::Texel rgbaOf(const std::uint16_t* pixel, int channels)
{
    switch (channels) {
    case 1:
        return {pixel[0], pixel[0], pixel[0], 65535};
    case 2:
        return {pixel[0], pixel[0], pixel[0], pixel[1]};
    case 3:
        return {pixel[0], pixel[1], pixel[2], 65535};
    default:
        return {pixel[0], pixel[1], pixel[2], pixel[3]};
    }
}

std::uint16_t greyOf(const sim::Texel& rgba)
{
    return static_cast<std::uint16_t>((rgba[0] + rgba[1] + rgba[2] + 1) / 3);
}

/// A grey of 0..1 spread over the palette's entries.
std::uint16_t greyToIndex(const MapSpec& spec, std::uint16_t grey)
{
    const auto last = static_cast<float>(std::max<std::size_t>(spec.palette.size(), 1) - 1);
    return static_cast<std::uint16_t>(std::lround(static_cast<float>(grey) / kGreatest * last));
}

sim::Texel texelFrom(const sim::Texel& rgba, const MapSpec& spec, bool grey)
{
    const std::uint16_t brightness = grey ? greyOf(rgba) : std::uint16_t{0};
    if (spec.texel == TexelKind::Colour)
        return grey ? sim::Texel{brightness, brightness, brightness, rgba[3]} : rgba;
    const float red = static_cast<float>(rgba[0]) / kGreatest;
    const float green = static_cast<float>(rgba[1]) / kGreatest;
    const float blue = static_cast<float>(rgba[2]) / kGreatest;
    if (spec.texel == TexelKind::Index)
        return {grey ? greyToIndex(spec, brightness) : colourToIndex(spec, red, green, blue), rgba[3], 0, 0};
    const auto value =
        grey ? brightness : static_cast<std::uint16_t>(std::lround(colourToScale(spec, red, green, blue) * kGreatest));
    return {value, rgba[3], 0, 0};
}

/// The paper and the full colour of a scale in 16 bits.
struct Scale
{
    sim::Texel paper{};
    sim::Texel full{};
    [[nodiscard]] std::uint16_t at(std::size_t channel, std::uint16_t value) const
    {
        const std::int64_t from = paper[channel];
        const std::int64_t way = (full[channel] - from) * value;
        return static_cast<std::uint16_t>(from + (way + (way < 0 ? -32767 : 32767)) / 65535);
    }
};

sim::Texel wide(QRgb colour)
{
    const auto widened = [](int channel) { return static_cast<std::uint16_t>(channel * 257); };
    return {widened(qRed(colour)), widened(qGreen(colour)), widened(qBlue(colour)), 65535};
}

sim::Texel rgbFrom(const sim::Texel& texel, const MapSpec& spec, const Scale& scale)
{
    if (spec.texel == TexelKind::Colour)
        return texel;
    if (spec.texel == TexelKind::Index) {
        const std::size_t index = texel[0];
        return index > 0 && index < spec.palette.size() ? wide(spec.palette[index].colour) : scale.paper;
    }
    return {scale.at(0, texel[0]), scale.at(1, texel[0]), scale.at(2, texel[0]), 0};
}

Scale scaleOf(const MapSpec& spec, bool nightPaper)
{
    Scale scale{.paper = wide(nightPaper ? 0xFF000000 : 0xFFFFFFFF), .full = wide(spec.scaleColour)};
    return scale;
}

QRgb narrow(const sim::Texel& rgb)
{
    const auto narrowed = [](std::uint16_t channel) { return (channel * 255 + 32767) / 65535; };
    return qRgb(narrowed(rgb[0]), narrowed(rgb[1]), narrowed(rgb[2]));
}

} // namespace

Result<sim::TiledRaster> layerFromImage(const ForeignImage& image, const MapSpec& spec, bool grey, int size)
{
    const bool whole = image.width > 0 && image.height > 0 && image.channels >= 1 && image.channels <= 4 &&
                       image.pixels.size() == static_cast<std::size_t>(image.width) *
                                                  static_cast<std::size_t>(image.height) *
                                                  static_cast<std::size_t>(image.channels);
    if (!whole)
        return failure(QCoreApplication::translate("Files", "The image holds no pixels; choose another."));
    const auto nextPowerOfTwo = [](int side) {
        return static_cast<int>(std::bit_ceil(
            static_cast<unsigned>(std::clamp(side, sim::TiledRaster::kSmallestSize, sim::TiledRaster::kLargestSize))));
    };
    const int target = size != 0 ? size : nextPowerOfTwo(std::max(image.width, image.height));
    const auto readRow = [&](int y, std::span<sim::Texel> texels) {
        const std::uint16_t* pixel =
            image.pixels.data() + static_cast<std::ptrdiff_t>(y) * image.width * image.channels;
        for (sim::Texel& texel : texels) {
            texel = texelFrom(rgbaOf(pixel, image.channels), spec, grey);
            pixel += image.channels;
        }
    };
    const bool fits = image.width == target && image.height == target;
    if (fits || !spec.bilinear())
        return resampleNearest(image.width, image.height, readRow, target, spec.layerChannels());
    return resampleBilinear(image.width, image.height, readRow, target, spec.layerChannels(), spec.defaultValue);
}

ForeignImage imageFromMap(const sim::TiledRaster& resolved, const MapSpec& spec)
{
    const int size = resolved.size();
    ForeignImage image{.width = size, .height = size, .channels = 3, .pixels = {}};
    image.pixels.reserve(static_cast<std::size_t>(size) * static_cast<std::size_t>(size) * 3);
    const Scale scale = scaleOf(spec, false);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const sim::Texel rgb = rgbFrom(resolved.texel(x, y), spec, scale);
            image.pixels.insert(image.pixels.end(), rgb.begin(), rgb.begin() + 3);
        }
    return image;
}

void paintMapTexels(const sim::TiledRaster& resolved, const MapSpec& spec, bool nightPaper, const sim::TexelRect& rect,
                    QRgb* pixels, int stride)
{
    constexpr int kTile = sim::TiledRaster::kTileSize;
    const Scale scale = scaleOf(spec, nightPaper && spec.texel != TexelKind::Colour);
    const auto colourOf = [&](const sim::Texel& texel) {
        return spec.texel == TexelKind::Scalar ? shownColour(spec, texel[0], nightPaper)
                                               : narrow(rgbFrom(texel, spec, scale));
    };
    const auto channels = static_cast<std::ptrdiff_t>(resolved.channels());
    for (int y = rect.y0; y < rect.y1; ++y) {
        QRgb* out = pixels + static_cast<std::ptrdiff_t>(y - rect.y0) * stride;
        for (int x = rect.x0; x < rect.x1;) {
            const int end = std::min(rect.x1, (x / kTile + 1) * kTile);
            const sim::RasterTile& tile = *resolved.tile(resolved.tileIndexAt(x, y));
            if (tile.isUniform()) {
                out = std::fill_n(out, end - x, colourOf(tile.uniform));
                x = end;
                continue;
            }
            const std::uint16_t* texel =
                tile.pixels.data() + (static_cast<std::ptrdiff_t>(y % kTile) * kTile + x % kTile) * channels;
            for (; x < end; ++x, texel += channels) {
                sim::Texel value{};
                std::copy_n(texel, channels, value.begin());
                *out++ = colourOf(value);
            }
        }
    }
}

} // namespace hairpaint::model
