// Layers to PNG and back.
#include "model/files/png_codec.h"

#include "model/files/png_reader.h"
#include "model/new_image.h"
#include "model/project.h"
#include "model/texel_ops.h"

#include <QBuffer>
#include <QImage>
#include <QImageWriter>
#include <QtEndian>

#include <algorithm>
#include <array>
#include <utility>

namespace hairpaint::model {

namespace {

constexpr int kTile = sim::TiledRaster::kTileSize;
constexpr int kDotsPerMeter = 2835; // 72 to an inch; Qt would write the screen's own
constexpr int kCompression = 20;    // of 100: zlib's level 1 or 2
constexpr int kRgb = 2;             // PNG's numbers of colour types
constexpr int kRgba = 6;
constexpr std::size_t kPixelBytes = 8;
constexpr std::uint16_t kVectorBlue = 32768; ///< Of layers of vectors, which have two values.

tl::unexpected<Clause> brokenImage()
{
    return refuse(say(QT_TRANSLATE_NOOP("Files", "one of its images is broken")));
}

/// Fills one row of texels from RGBA64 in PNG's byte order; true where it held just what encodeLayer would write.
bool takeRow(const std::uint8_t* bytes, std::uint16_t* texels, int count, int channels, std::uint16_t greatestIndex)
{
    bool ours = true;
    for (int x = 0; x < count; ++x, bytes += kPixelBytes, texels += channels) {
        std::array<std::uint16_t, 4> rgba{};
        qFromBigEndian<quint16>(bytes, 4, rgba.data());
        if (channels == 4) {
            std::copy_n(rgba.begin(), 4, texels);
            continue;
        }
        if (channels == 3) {
            ours = ours && rgba[2] == kVectorBlue;
            std::copy_n(rgba.begin(), 2, texels);
            texels[2] = rgba[3];
            continue;
        }
        ours = ours && rgba[1] == rgba[0] && rgba[2] == rgba[0] && rgba[0] <= greatestIndex;
        texels[0] = rgba[0] <= greatestIndex ? rgba[0] : std::uint16_t{0};
        texels[1] = rgba[3];
    }
    return ours;
}

/// Puts tiles into a raster; those of one value are folded, and neighbours of the same value share one tile.
class TileFolder
{
public:
    explicit TileFolder(sim::TiledRaster& raster) : m_raster(raster), m_lastUniform(raster.tile(0)) {}

    /// Takes `pixels` away where the tile keeps them.
    void put(int index, std::vector<std::uint16_t>& pixels)
    {
        const std::optional<sim::Texel> value = sim::commonTexel(pixels);
        auto tile = std::make_shared<sim::RasterTile>();
        if (!value) {
            tile->pixels = std::exchange(pixels, {});
            m_raster.setTile(index, std::move(tile));
            return;
        }
        tile->uniform = *value;
        if (m_lastUniform->uniform != tile->uniform)
            m_lastUniform = std::move(tile);
        m_raster.setTile(index, m_lastUniform);
    }

private:
    sim::TiledRaster& m_raster;
    sim::RasterTilePtr m_lastUniform;
};

bool isLayer(const PngParts& parts, int size)
{
    const auto side = static_cast<std::uint32_t>(size);
    return parts.width == side && parts.height == side && parts.depth == 16 && parts.colourType == kRgba &&
           !parts.interlaced;
}

/// Texels on which nothing is painted.
void leaveEmpty(std::span<std::uint16_t> texels, const MapSpec& spec)
{
    const sim::Texel empty = emptyTexel(spec);
    const auto channels = static_cast<std::size_t>(spec.layerChannels());
    for (std::size_t at = 0; at < texels.size(); at += channels)
        std::copy_n(empty.begin(), channels, texels.begin() + static_cast<std::ptrdiff_t>(at));
}

/// Fills the layer from the top with what rows there are, at most its own; how many they were.
int takeRows(PngRows& rows, const MapSpec& spec, DecodedLayer& layer)
{
    const int channels = layer.raster.channels();
    const std::uint16_t greatest = texelOps(spec).greatest(spec);
    TileFolder folder(layer.raster);
    const int across = layer.raster.size() / kTile;
    std::vector<std::vector<std::uint16_t>> tiles(static_cast<std::size_t>(across));
    for (int tileRow = 0; tileRow < across; ++tileRow) {
        for (std::vector<std::uint16_t>& pixels : tiles)
            pixels.resize(static_cast<std::size_t>(kTile) * kTile * static_cast<std::size_t>(channels));
        int taken = 0;
        for (; taken < kTile; ++taken) {
            const std::span<const std::uint8_t> row = rows.next();
            if (row.empty())
                break;
            for (int column = 0; column < across; ++column) {
                std::uint16_t* texels =
                    tiles[static_cast<std::size_t>(column)].data() + std::ptrdiff_t{taken} * kTile * channels;
                const std::uint8_t* bytes =
                    row.data() + std::size_t{kPixelBytes} * kTile * static_cast<std::size_t>(column);
                layer.ours = takeRow(bytes, texels, kTile, channels, greatest) && layer.ours;
            }
        }
        for (int column = 0; column < across && taken > 0; ++column) {
            std::vector<std::uint16_t>& pixels = tiles[static_cast<std::size_t>(column)];
            leaveEmpty(
                std::span(pixels).subspan(static_cast<std::size_t>(taken) * kTile * static_cast<std::size_t>(channels)),
                spec);
            folder.put(tileRow * across + column, pixels);
        }
        if (taken < kTile)
            return tileRow * kTile + taken;
    }
    return layer.raster.size();
}

} // namespace

QByteArray encodeLayer(const sim::TiledRaster& raster)
{
    const int size = raster.size();
    const int channels = raster.channels();
    QImage image = newImage(size, size, QImage::Format_RGBA64);
    for (int index = 0; index < raster.tileCount(); ++index) {
        const sim::RasterTile& tile = *raster.tile(index);
        const sim::TexelRect rect = raster.tileRect(index);
        for (int y = 0; y < kTile; ++y) {
            auto* rgba = reinterpret_cast<quint16*>(image.scanLine(rect.y0 + y)) + std::ptrdiff_t{4} * rect.x0;
            const std::uint16_t* texel =
                tile.isUniform() ? tile.uniform.data() : tile.pixels.data() + std::ptrdiff_t{y} * kTile * channels;
            const int step = tile.isUniform() ? 0 : channels;
            for (int x = 0; x < kTile; ++x, rgba += 4, texel += step) {
                rgba[0] = texel[0];
                rgba[1] = texel[channels > 2 ? 1 : 0];
                rgba[2] = channels == 4 ? texel[2] : channels == 3 ? kVectorBlue : texel[0];
                rgba[3] = texel[channels - 1];
            }
        }
    }
    image.setDotsPerMeterX(kDotsPerMeter);
    image.setDotsPerMeterY(kDotsPerMeter);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QImageWriter writer(&buffer, "png");
    writer.setCompression(kCompression);
    if (!writer.write(image))
        bytes.clear();
    return bytes;
}

Checked<DecodedLayer> decodeLayer(const QByteArray& png, const MapSpec& spec, int size)
{
    const std::optional<PngParts> parts = readPngParts(png);
    if (!parts)
        return brokenImage();
    if (!isLayer(*parts, size))
        return refuse(say(QT_TRANSLATE_NOOP("Files", "one of its images is not %1 x %1 in 16-bit RGBA")).arg(size));

    DecodedLayer layer{.raster = sim::TiledRaster(size, spec.layerChannels()), .ours = parts->onlyPixelsAndDpi};
    PngRows rows(parts->packedPixels, kPixelBytes * static_cast<std::size_t>(size), kPixelBytes);
    if (takeRows(rows, spec, layer) != size || !rows.atEnd())
        return brokenImage();
    return layer;
}

SalvagedLayer salvageLayer(const QByteArray& png, const MapSpec& spec, int size)
{
    DecodedLayer layer{.raster = emptyRaster(spec, size)};
    const std::optional<PngParts> header = readPngHeader(png);
    if (header && !isLayer(*header, size))
        return {.raster = std::move(layer.raster)};
    const QByteArray packed = packedPixelsOf(png);
    PngRows rows(packed, kPixelBytes * static_cast<std::size_t>(size), kPixelBytes);
    const int count = takeRows(rows, spec, layer);
    return {.raster = std::move(layer.raster), .rows = count};
}

QImage decodePicture(const QByteArray& png, int mostSide)
{
    const std::optional<PngParts> parts = readPngParts(png);
    const auto most = static_cast<std::uint32_t>(mostSide);
    if (!parts || parts->width > most || parts->height > most || parts->depth != 8 || parts->interlaced ||
        (parts->colourType != kRgb && parts->colourType != kRgba))
        return {};
    const bool hasAlpha = parts->colourType == kRgba;
    QImage image = newImage(static_cast<int>(parts->width), static_cast<int>(parts->height),
                            hasAlpha ? QImage::Format_RGBA8888 : QImage::Format_RGB888);
    PngRows rows(parts->packedPixels, std::size_t{parts->width} * (hasAlpha ? 4 : 3), hasAlpha ? 4 : 3);
    for (int y = 0; y < image.height(); ++y) {
        const std::span<const std::uint8_t> row = rows.next();
        if (row.empty())
            return {};
        std::ranges::copy(row, image.scanLine(y));
    }
    return rows.atEnd() ? image : QImage();
}

} // namespace hairpaint::model
