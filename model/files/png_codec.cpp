// Layers to PNG and back.
#include "model/files/png_codec.h"

#include "model/files/png_reader.h"
#include "model/maps/new_image.h"
#include "model/maps/texel_ops.h"
#include "model/project/project.h"
#include "sim/base/parallel.h"

#include <QImage>
#include <QtEndian>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace hairpaint::model {

namespace {

constexpr int kTile = sim::TiledRaster::kTileSize;
constexpr int kGrey = 0; // PNG's numbers of colour types
constexpr int kRgb = 2;
constexpr int kRgba = 6;
constexpr std::size_t kPixelBytes = 8;
constexpr std::uint16_t kVectorBlue = 32768; ///< Blue of layers of vectors, whose two values are in red and green.

tl::unexpected<Clause> brokenImage()
{
    return refuse(say(QT_TRANSLATE_NOOP("Files", "one of its images is broken")));
}

/// Fills one row of texels from RGBA64 in PNG's byte order; true where it held just what encodeLayer would write.
template<int channels>
bool takeChannels(const std::uint8_t* bytes, std::uint16_t* texels, int count, std::uint16_t greatestIndex)
{
    const auto channel = [](quint64 rgba, unsigned number) {
        return static_cast<std::uint16_t>(rgba >> (48U - 16U * number));
    };
    bool ours = true;
    for (int x = 0; x < count; ++x, bytes += kPixelBytes, texels += channels) {
        const auto rgba = qFromBigEndian<quint64>(bytes);
        if constexpr (channels == 4) {
            for (unsigned i = 0; i < 4; ++i)
                texels[i] = channel(rgba, i);
        } else if constexpr (channels == 3) {
            ours &= channel(rgba, 2) == kVectorBlue;
            texels[0] = channel(rgba, 0);
            texels[1] = channel(rgba, 1);
            texels[2] = channel(rgba, 3);
        } else {
            const std::uint16_t value = channel(rgba, 0);
            const bool isKnown = value <= greatestIndex;
            ours &= isKnown && channel(rgba, 1) == value && channel(rgba, 2) == value;
            texels[0] = isKnown ? value : std::uint16_t{0};
            texels[1] = channel(rgba, 3);
        }
    }
    return ours;
}

bool takeRow(const std::uint8_t* bytes, std::uint16_t* texels, int count, int channels, std::uint16_t greatestIndex)
{
    switch (channels) {
    case 4:
        return takeChannels<4>(bytes, texels, count, greatestIndex);
    case 3:
        return takeChannels<3>(bytes, texels, count, greatestIndex);
    default:
        return takeChannels<2>(bytes, texels, count, greatestIndex);
    }
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

/// As encodeLayer writes it, or grey alone, which is a third of the bytes where a layer of one value covers all.
bool isLayer(const PngParts& parts, const MapSpec& spec, int size)
{
    const auto side = static_cast<std::uint32_t>(size);
    return parts.width == side && parts.height == side && parts.depth == 16 && !parts.interlaced &&
           (parts.colourType == kRgba || (parts.colourType == kGrey && spec.layerChannels() == 2));
}

/// The rows of a layer's image, grey ones as RGBA.
class LayerRows
{
public:
    LayerRows(QByteArrayView pixelChunks, int colourType, int size)
        : m_isGrey(colourType == kGrey),
          m_rows(pixelChunks, (m_isGrey ? kGreyBytes : kPixelBytes) * static_cast<std::size_t>(size),
                 m_isGrey ? kGreyBytes : kPixelBytes),
          m_row(m_isGrey ? kPixelBytes * static_cast<std::size_t>(size) : 0)
    {}

    /// As PngRows::next().
    [[nodiscard]] std::span<const std::uint8_t> next()
    {
        const std::span<const std::uint8_t> row = m_rows.next();
        if (!m_isGrey || row.empty())
            return row;
        for (std::size_t x = 0; x * kGreyBytes < row.size(); ++x) {
            const quint64 value = qFromBigEndian<quint16>(row.data() + x * kGreyBytes);
            qToBigEndian(value << 48U | value << 32U | value << 16U | 0xFFFFU, m_row.data() + x * kPixelBytes);
        }
        return m_row;
    }
    [[nodiscard]] bool atEnd() { return m_rows.atEnd(); }

private:
    static constexpr std::size_t kGreyBytes = 2;
    bool m_isGrey;
    PngRows m_rows;
    std::vector<std::uint8_t> m_row;
};

/// Texels on which nothing is painted.
void leaveEmpty(std::span<std::uint16_t> texels, const MapSpec& spec)
{
    const sim::Texel empty = emptyTexel(spec);
    const auto channels = static_cast<std::size_t>(spec.layerChannels());
    for (std::size_t at = 0; at < texels.size(); at += channels)
        std::copy_n(empty.begin(), channels, texels.begin() + static_cast<std::ptrdiff_t>(at));
}

/// Fills the layer from the top with what rows there are, at most its own; how many they were.
int takeRows(LayerRows& rows, const MapSpec& spec, DecodedLayer& layer)
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

/// Whether a row of tiles holds the very tiles, or uniform ones of the same values, of another.
bool sameTiles(const sim::TiledRaster& a, std::size_t rowOfA, const sim::TiledRaster& b, std::size_t rowOfB)
{
    const int across = a.tilesAcross();
    for (int column = 0; column < across; ++column) {
        const sim::RasterTilePtr& one = a.tile(static_cast<int>(rowOfA) * across + column);
        const sim::RasterTilePtr& other = b.tile(static_cast<int>(rowOfB) * across + column);
        if (one != other && !(one->isUniform() && other->isUniform() && one->uniform == other->uniform))
            return false;
    }
    return true;
}

/// Writes a tile's texels where they lie among those of its row of tiles.
void giveTile(const sim::TiledRaster& raster, int index, PngRowBuffer& rows)
{
    const sim::RasterTile& tile = *raster.tile(index);
    const int channels = raster.channels();
    const std::size_t first = kPixelBytes * static_cast<std::size_t>(raster.tileRect(index).x0);
    const int step = tile.isUniform() ? 0 : channels;
    for (int y = 0; y < kTile; ++y) {
        std::uint8_t* bytes = rows.row(y).data() + first;
        const std::uint16_t* texel =
            tile.isUniform() ? tile.uniform.data() : tile.pixels.data() + std::ptrdiff_t{y} * kTile * channels;
        for (int x = 0; x < kTile; ++x, bytes += kPixelBytes, texel += step) {
            const quint64 red = texel[0];
            const quint64 green = texel[channels > 2 ? 1 : 0];
            const quint64 blue = channels == 4 ? texel[2] : channels == 3 ? kVectorBlue : texel[0];
            qToBigEndian(red << 48U | green << 32U | blue << 16U | texel[channels - 1], bytes);
        }
    }
}

} // namespace

PngFile encodeLayer(const sim::TiledRaster& raster, const EncodedLayer* former)
{
    const int across = raster.tilesAcross();
    std::vector<PngBand> bands(static_cast<std::size_t>(across));
    std::vector<std::size_t> sources(bands.size());
    for (std::size_t band = 1; band < bands.size(); ++band)
        sources[band] = sameTiles(raster, band, raster, band - 1) ? sources[band - 1] : band;
    const bool isKept = former != nullptr && former->png.stored.size() == bands.size();
    sim::parallelFor(bands.size(), 1, [&](std::size_t begin, std::size_t end) {
        std::optional<PngRowBuffer> rows;
        for (std::size_t band = begin; band < end; ++band) {
            if (sources[band] != band)
                continue;
            if (isKept && sameTiles(raster, band, former->raster, band)) {
                bands[band] = former->png.band(band);
                continue;
            }
            if (!rows)
                rows.emplace(raster.size(), kTile);
            for (int column = 0; column < across; ++column)
                giveTile(raster, static_cast<int>(band) * across + column, *rows);
            bands[band] = packBand(*rows);
        }
    });
    for (std::size_t band = 0; band < bands.size(); ++band)
        bands[band] = bands[sources[band]];
    return pngOf(raster.size(), raster.size(), bands);
}

Checked<DecodedLayer> decodeLayer(const QByteArray& png, const MapSpec& spec, int size)
{
    const std::optional<PngParts> parts = readPngParts(png);
    if (!parts)
        return brokenImage();
    if (!isLayer(*parts, spec, size))
        return refuse(say(QT_TRANSLATE_NOOP("Files", "one of its images is not %1 x %1 in 16-bit RGBA")).arg(size));

    DecodedLayer layer{.raster = sim::TiledRaster(size, spec.layerChannels()),
                       .ours = parts->onlyPixelsAndDpi && parts->colourType == kRgba,
                       .checksum = parts->checksum};
    LayerRows rows(parts->pixelChunks, parts->colourType, size);
    if (takeRows(rows, spec, layer) != size || !rows.atEnd())
        return brokenImage();
    return layer;
}

SalvagedLayer salvageLayer(const QByteArray& png, const MapSpec& spec, int size)
{
    DecodedLayer layer{.raster = emptyRaster(spec, size)};
    const std::optional<PngParts> header = readPngHeader(png);
    if (header && !isLayer(*header, spec, size))
        return {.raster = std::move(layer.raster)};
    LayerRows rows(pixelChunksOf(png), header ? header->colourType : kRgba, size);
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
    PngRows rows(parts->pixelChunks, std::size_t{parts->width} * (hasAlpha ? 4 : 3), hasAlpha ? 4 : 3);
    for (int y = 0; y < image.height(); ++y) {
        const std::span<const std::uint8_t> row = rows.next();
        if (row.empty())
            return {};
        std::ranges::copy(row, image.scanLine(y));
    }
    return rows.atEnd() ? image : QImage();
}

} // namespace hairpaint::model
