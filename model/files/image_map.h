// Images as maps and maps as images, through each map's colour scale.
#pragma once

#include "model/files/importer_client.h"
#include "model/project/project.h"
#include "model/values/error.h"

#include <QSize>

#include <optional>

namespace hairpaint::model {

/// Reads an image as a layer of the map: by the map's scale, or `grey` as the value itself. Resampled bilinearly
/// (indices: nearest) to `size`, or where `size` is 0 to the next power of two of 256..8192 from the image's longer
/// side or four times its shorter one, whichever is less. Alpha becomes coverage.
[[nodiscard]] Result<sim::TiledRaster> layerFromImage(const ForeignImage& image, const MapSpec& spec, bool grey,
                                                      int size);

/// The side of the map that an image makes where `size` is 0.
[[nodiscard]] int mapSideOf(const ForeignImage& image);

struct ImageLayer
{
    sim::TiledRaster raster;
    QSize imageSize; ///< Size of the image as it was read, px.
};

/// An image of any format that the helper program reads, for a map: colours as sRGB, all others as they are stored.
[[nodiscard]] Result<ForeignImage> imageForMap(ImporterClient& client, const QString& path, const MapSpec& spec,
                                               const Progress& progress = {});
/// The same as a layer. `grey`: none leaves it to what its pixels tell (image_reading.h), and to the map's scale where
/// they tell both.
[[nodiscard]] Result<ImageLayer> layerFromFile(ImporterClient& client, const QString& path, const MapSpec& spec,
                                               std::optional<bool> grey, int size, const Progress& progress = {});

/// A resolved map as an image in its scale, white to colour as in the paper; `grey`: of one channel, the value, where
/// a grey can tell it.
[[nodiscard]] ForeignImage imageFromMap(const sim::TiledRaster& resolved, const MapSpec& spec, bool grey = false);
/// A layer in its scale, its coverage as alpha: layerFromImage gives the layer again.
[[nodiscard]] ForeignImage imageFromLayer(const sim::TiledRaster& layer, const MapSpec& spec);

/// For the paint area: texels of `rect` as ARGB32 in the scale that is shown, on night paper or white.
void paintMapTexels(const sim::TiledRaster& resolved, const MapSpec& spec, bool nightPaper, const sim::TexelRect& rect,
                    QRgb* pixels, int stride);
/// The same of every `apart`-th texel along both axes, in the middle of those it stands for. `apart`: a power of two,
/// at most a raster tile's side; `rect` is a multiple of it.
void paintMapSamples(const sim::TiledRaster& resolved, const MapSpec& spec, bool nightPaper, const sim::TexelRect& rect,
                     int apart, QRgb* pixels, int stride);

} // namespace hairpaint::model
