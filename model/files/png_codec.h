// Layers as 16-bit RGBA PNG images, and back: see "Layers" in model/files/hairpaint_format.md.
// Any thread. Errors: clauses for a sentence of sentences.h.
#pragma once

#include "model/files/png_writer.h"
#include "model/project/map_spec.h"
#include "model/values/sentences.h"

#include <QByteArray>
#include <QImage>

namespace hairpaint::model {

/// Bytes that a layer's PNG may have at most.
[[nodiscard]] constexpr qint64 mostLayerBytes(int size)
{
    const qint64 pixels = qint64{8} * size * size;
    return pixels + pixels / 64 + 65'536;
}

/// A layer and its image.
struct EncodedLayer
{
    sim::TiledRaster raster;
    PngFile png;
};
/// The same texels give the same bytes. Rows of tiles that are those of `former`, of the same shape, are not packed
/// again.
[[nodiscard]] PngFile encodeLayer(const sim::TiledRaster& raster, const EncodedLayer* former = nullptr);

struct DecodedLayer
{
    sim::TiledRaster raster;
    /// encodeLayer(raster) may be taken to give the bytes read: nothing in them was left out or mended.
    bool ours = true;
    std::uint32_t checksum = 0; ///< CRC-32 of the image's bytes.
};

/// `size`: the side that the image must have. Tiles of one value are folded.
[[nodiscard]] Checked<DecodedLayer> decodeLayer(const QByteArray& png, const MapSpec& spec, int size);

/// What stands before the damage in a layer's image, from the top down; below it nothing is painted.
struct SalvagedLayer
{
    sim::TiledRaster raster;
    int rows = 0; ///< Number of rows that could be read, 0..size.
};
[[nodiscard]] SalvagedLayer salvageLayer(const QByteArray& png, const MapSpec& spec, int size);

/// A picture of 8 bits a channel, such as QImage writes, neither side over `mostSide`; null where it is anything else.
[[nodiscard]] QImage decodePicture(const QByteArray& png, int mostSide);

} // namespace hairpaint::model
