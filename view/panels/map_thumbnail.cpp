// Small pictures: each pixel is the middle of a few texels of its fraction of the raster.
#include "view/panels/map_thumbnail.h"

#include "model/maps/texel_ops.h"

#include <algorithm>
#include <array>

namespace hairpaint::view {

namespace {

/// Texels read along each side of a pixel's area; more would not be seen.
constexpr int kTaps = 3;

struct Tap
{
    QRgb colour = 0; ///< Opaque.
    double weight = 0.0;
};

template<typename Read>
QImage pictureOf(const sim::TiledRaster& raster, int side, const Read& read)
{
    QImage image(side, side, QImage::Format_ARGB32_Premultiplied);
    const double fraction = static_cast<double>(raster.size()) / side;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            std::array<double, 3> sum{};
            double weight = 0.0;
            for (int tap = 0; tap < kTaps * kTaps; ++tap) {
                const int column = tap % kTaps;
                const int row = tap / kTaps;
                const int tx = static_cast<int>((x + (column + 0.5) / kTaps) * fraction);
                const int ty = static_cast<int>((y + (row + 0.5) / kTaps) * fraction);
                const Tap one = read(raster.texel(tx, ty));
                sum[0] += qRed(one.colour) * one.weight;
                sum[1] += qGreen(one.colour) * one.weight;
                sum[2] += qBlue(one.colour) * one.weight;
                weight += one.weight;
            }
            constexpr double kAll = kTaps * kTaps;
            image.setPixel(x, y,
                           qRgba(qRound(sum[0] / kAll), qRound(sum[1] / kAll), qRound(sum[2] / kAll),
                                 qRound(weight / kAll * 255.0)));
        }
    }
    return image;
}

} // namespace

QImage mapThumbnail(const sim::TiledRaster& resolved, const model::MapSpec& spec, bool nightPaper, int side)
{
    return pictureOf(resolved, std::max(side, 1), [&](const sim::Texel& texel) {
        return Tap{model::colourOfTexel(spec, texel, nightPaper), 1.0};
    });
}

QImage layerThumbnail(const model::Layer& layer, const model::MapSpec& spec, bool nightPaper, int side)
{
    const auto coverage = static_cast<std::size_t>(spec.valueChannels);
    return pictureOf(layer.raster, std::max(side, 1), [&](const sim::Texel& texel) {
        if (texel[coverage] == 0)
            return Tap{};
        return Tap{model::colourOfTexel(spec, texel, nightPaper), texel[coverage] / 65535.0};
    });
}

} // namespace hairpaint::view
