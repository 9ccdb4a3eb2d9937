// Point-sampled pictures of rasters.
#include "view/thumbnails.h"

#include "model/files/image_map.h"

#include <algorithm>

namespace hairpaint::view {

namespace {

constexpr std::uint16_t kHalf = 0x8000;

/// A small raster with the values (not the coverage) of a large one at the centres of its cells.
sim::TiledRaster sampledValues(const sim::TiledRaster& raster, int valueChannels, int side)
{
    sim::TiledRaster small(side, valueChannels);
    const int step = std::max(1, raster.size() / side);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            sim::Texel texel = raster.texel(std::min(x * step + step / 2, raster.size() - 1),
                                            std::min(y * step + step / 2, raster.size() - 1));
            std::fill(texel.begin() + valueChannels, texel.end(), std::uint16_t{0});
            small.setTexel(x, y, texel);
        }
    }
    return small;
}

QImage painted(const sim::TiledRaster& raster, const model::MapSpec& spec, bool nightPaper)
{
    QImage image(raster.size(), raster.size(), QImage::Format_ARGB32);
    model::paintMapTexels(raster, spec, nightPaper, raster.bounds(), reinterpret_cast<QRgb*>(image.bits()),
                          static_cast<int>(image.bytesPerLine() / 4));
    return image;
}

/// A power of two of at least twice the wanted side, so that scaling down smooths.
int sampledSide(int sidePx, int rasterSize)
{
    int side = 64;
    while (side < 2 * sidePx && side < rasterSize)
        side *= 2;
    return std::min(side, rasterSize);
}

} // namespace

QImage mapThumbnail(const sim::TiledRaster& resolved, const model::MapSpec& spec, bool nightPaper, int sidePx)
{
    const int side = sampledSide(sidePx, resolved.size());
    return painted(sampledValues(resolved, spec.valueChannels, side), spec, nightPaper)
        .scaled(sidePx, sidePx, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

QImage layerThumbnail(const model::Layer& layer, const model::MapSpec& spec, bool nightPaper, int sidePx)
{
    const int side = sampledSide(sidePx, layer.raster.size());
    QImage image = painted(sampledValues(layer.raster, spec.valueChannels, side), spec, nightPaper);
    const int step = std::max(1, layer.raster.size() / side);
    for (int y = 0; y < side; ++y) {
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (int x = 0; x < side; ++x) {
            const std::uint16_t coverage = layer.raster.texel(
                x * step + step / 2, y * step + step / 2)[static_cast<std::size_t>(spec.valueChannels)];
            const int alpha = spec.bilinear() ? coverage / 257 : (coverage >= kHalf ? 255 : 0);
            line[x] = qRgba(qRed(line[x]), qGreen(line[x]), qBlue(line[x]), alpha);
        }
    }
    return image.scaled(sidePx, sidePx, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

} // namespace hairpaint::view
