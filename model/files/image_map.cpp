// Images to maps and back. Values are read from and written as encoded channels; nothing is linearised.
#include "model/files/image_map.h"

#include "model/maps/image_reading.h"
#include "model/maps/image_resample.h"
#include "model/maps/map_colours.h"
#include "model/maps/texel_ops.h"
#include "model/values/sentences.h"
#include "model/values/texel_math.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <bit>

namespace hairpaint::model {

namespace {

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

/// visit(x, texels, step, count) for each run of texels of row `y` that lie `step` channels apart in one tile; a step
/// of 0: all are the same.
template<typename Visit>
void forEachRun(const sim::TiledRaster& map, const sim::TexelRect& rect, int y, const Visit& visit)
{
    constexpr int kTile = sim::TiledRaster::kTileSize;
    const int channels = map.channels();
    for (int x = rect.x0; x < rect.x1;) {
        const int end = std::min(rect.x1, (x / kTile + 1) * kTile);
        const sim::RasterTile& tile = *map.tile(map.tileIndexAt(x, y));
        if (tile.isUniform())
            visit(x, tile.uniform.data(), std::size_t{0}, end - x);
        else
            visit(x, tile.pixels.data() + (std::ptrdiff_t{y % kTile} * kTile + x % kTile) * channels,
                  static_cast<std::size_t>(channels), end - x);
        x = end;
    }
}

/// Texels of one row of a tile, or of part of it, as colours.
using RowColours = std::array<std::uint16_t, std::size_t{3} * sim::TiledRaster::kTileSize>;

} // namespace

int mapSideOf(const ForeignImage& image)
{
    constexpr int kMostStretch = 4;
    const auto [shorter, longer] = std::minmax(image.width, image.height);
    const int wanted = shorter < longer / kMostStretch ? shorter * kMostStretch : longer;
    return static_cast<int>(std::bit_ceil(
        static_cast<unsigned>(std::clamp(wanted, sim::TiledRaster::kSmallestSize, sim::TiledRaster::kLargestSize))));
}

Result<sim::TiledRaster> layerFromImage(const ForeignImage& image, const MapSpec& spec, bool grey, int size)
{
    const bool whole = image.width > 0 && image.height > 0 && image.channels >= 1 && image.channels <= 4 &&
                       image.pixels.size() == static_cast<std::size_t>(image.width) *
                                                  static_cast<std::size_t>(image.height) *
                                                  static_cast<std::size_t>(image.channels);
    if (!whole)
        return failure(QCoreApplication::translate("Files", "The image holds no pixels; choose another."));
    const int target = size != 0 ? size : mapSideOf(image);
    const TexelOps& ops = texelOps(spec);
    const auto readRow = [&](int y, std::span<sim::Texel> texels) {
        const std::uint16_t* pixel =
            image.pixels.data() + static_cast<std::ptrdiff_t>(y) * image.width * image.channels;
        for (sim::Texel& texel : texels) {
            texel = rgbaOf(pixel, image.channels);
            pixel += image.channels;
        }
        grey ? ops.fromGreys(spec, texels) : ops.fromColours(spec, texels);
    };
    const bool fits = image.width == target && image.height == target;
    if (fits || !spec.bilinear())
        return resampleNearest(image.width, image.height, readRow, target, spec.layerChannels());
    return resampleBilinear(image.width, image.height, readRow, target, spec.layerChannels(), spec.defaultValue);
}

Result<ForeignImage> imageForMap(ImporterClient& client, const QString& path, const MapSpec& spec,
                                 const Progress& progress)
{
    return spec.texel == TexelKind::Colour ? client.readColours(path, progress) : client.readImage(path, progress);
}

Result<ImageLayer> layerFromFile(ImporterClient& client, const QString& path, const MapSpec& spec,
                                 std::optional<bool> grey, int size, const Progress& progress)
{
    return withinMemory(path, cannotOpen, [&]() -> Result<ImageLayer> {
        const Result<ForeignImage> image = imageForMap(client, path, spec, progress);
        if (!image)
            return tl::unexpected(image.error());
        const bool isGrey = grey.value_or(readingOf(image->pixels, image->channels, spec) == ImageReading::Value);
        Result<sim::TiledRaster> raster = layerFromImage(*image, spec, isGrey, size);
        if (!raster)
            return tl::unexpected(raster.error());
        return ImageLayer{.raster = std::move(*raster), .imageSize = {image->width, image->height}};
    });
}

ForeignImage imageFromMap(const sim::TiledRaster& resolved, const MapSpec& spec, bool grey)
{
    const int size = resolved.size();
    const TexelOps& ops = texelOps(spec);
    const bool isGrey = grey && ops.toGreys != nullptr;
    ForeignImage image{.width = size,
                       .height = size,
                       .channels = isGrey ? 1 : 3,
                       .pixels = {},
                       .areColours = spec.texel == TexelKind::Colour};
    image.pixels.resize(static_cast<std::size_t>(size) * static_cast<std::size_t>(size) *
                        static_cast<std::size_t>(image.channels));
    for (int y = 0; y < size; ++y)
        forEachRun(resolved, {0, y, size, y + 1}, y,
                   [&](int x, const std::uint16_t* texels, std::size_t step, int count) {
                       std::uint16_t* out = image.pixels.data() + (std::ptrdiff_t{y} * size + x) * image.channels;
                       if (isGrey)
                           ops.toGreys(spec, texels, step, static_cast<std::size_t>(count), out);
                       else
                           ops.toColours(spec, false, texels, step, static_cast<std::size_t>(count), out);
                   });
    return image;
}

ForeignImage imageFromLayer(const sim::TiledRaster& layer, const MapSpec& spec)
{
    constexpr int kChannels = 4;
    const int size = layer.size();
    ForeignImage image{.width = size,
                       .height = size,
                       .channels = kChannels,
                       .pixels = {},
                       .areColours = spec.texel == TexelKind::Colour};
    image.pixels.reserve(static_cast<std::size_t>(size) * static_cast<std::size_t>(size) * kChannels);
    RowColours colours{};
    for (int y = 0; y < size; ++y)
        forEachRun(
            layer, {0, y, size, y + 1}, y, [&](int /*x*/, const std::uint16_t* texels, std::size_t step, int count) {
                texelOps(spec).toColours(spec, false, texels, step, static_cast<std::size_t>(count), colours.data());
                for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
                    image.pixels.insert(image.pixels.end(), colours.begin() + 3 * static_cast<std::ptrdiff_t>(i),
                                        colours.begin() + 3 * static_cast<std::ptrdiff_t>(i + 1));
                    image.pixels.push_back(texels[i * step + static_cast<std::size_t>(spec.valueChannels)]);
                }
            });
    return image;
}

void paintMapTexels(const sim::TiledRaster& resolved, const MapSpec& spec, bool nightPaper, const sim::TexelRect& rect,
                    QRgb* pixels, int stride)
{
    paintMapSamples(resolved, spec, nightPaper, rect, 1, pixels, stride);
}

void paintMapSamples(const sim::TiledRaster& resolved, const MapSpec& spec, bool nightPaper, const sim::TexelRect& rect,
                     int apart, QRgb* pixels, int stride)
{
    RowColours colours{};
    const auto narrow = [](const std::uint16_t* rgb) {
        return qRgb(narrowed(rgb[0]), narrowed(rgb[1]), narrowed(rgb[2]));
    };
    const auto middle = static_cast<std::size_t>(apart / 2);
    for (int y = rect.y0 + apart / 2; y < rect.y1; y += apart) {
        QRgb* out = pixels + static_cast<std::ptrdiff_t>((y - rect.y0) / apart) * stride;
        forEachRun(resolved, rect, y, [&](int /*x*/, const std::uint16_t* texels, std::size_t step, int count) {
            const int samples = count / apart;
            const int different = step == 0 ? 1 : samples;
            shownColours(spec, nightPaper, texels + middle * step, step * static_cast<std::size_t>(apart),
                         static_cast<std::size_t>(different), colours.data());
            for (int i = 0; i < different; ++i)
                out[i] = narrow(colours.data() + std::ptrdiff_t{3} * i);
            std::fill(out + different, out + samples, out[0]);
            out += samples;
        });
    }
}

} // namespace hairpaint::model
