// Tiles read one after another, and laid at their cells by the nearest texel.
#include "model/files/map_source.h"

#include "model/files/tile_names.h"
#include "model/maps/image_resample.h"
#include "model/values/sentences.h"

#include <algorithm>
#include <optional>

namespace hairpaint::model {

namespace {

Result<MapSource> tilesFrom(ImporterClient& client, const QString& path, const MapSpec& spec, const UvTiles& tiles,
                            const Progress& progress)
{
    const Checked<std::vector<TileFile>> files = tileFilesOf(path);
    if (!files)
        return cannotOpen(path, files.error());
    if (const std::optional<int> shared = tiles.shared())
        return cannotOpen(path, {.text = say(QT_TRANSLATE_NOOP("Files", "several layouts of the head lie in its tile "
                                                                        "%1, so images by tile can't be told apart; "
                                                                        "paint on one image of all of the map"))
                                             .arg(*shared),
                                 .cure = Clause::Cure::OtherFile});
    MapSource source{.images = {}, .cells = {}, .tiles = tiles, .leftOut = {}};
    for (std::size_t i = 0; i < files->size(); ++i) {
        const TileFile& file = (*files)[i];
        const std::optional<std::size_t> cell = tiles.cellOf(file.number);
        if (!cell) {
            source.leftOut.push_back(file.number);
            continue;
        }
        const auto part = [&](double done) {
            return !progress || progress((static_cast<double>(i) + done) / static_cast<double>(files->size()));
        };
        Result<ForeignImage> image = imageForMap(client, file.path, spec, part);
        if (!image)
            return tl::unexpected(image.error());
        source.images.push_back(std::move(*image));
        source.cells.push_back(*cell);
    }
    if (source.images.empty())
        return cannotOpen(
            path,
            {.text = say(QT_TRANSLATE_NOOP(
                             "Files",
                             "none of its tiles is one of the head's, as %1 is; number its images by the head's tiles"))
                         .arg(tiles.numbers().front()),
             .cure = Clause::Cure::OtherFile});
    return source;
}

/// Where the middle of texel `at` of a map of `side` lies: in which cell, and in which of a cell's `cellSide` texels.
struct InCell
{
    int cell = 0, texel = 0;
};
InCell inCell(int at, int side, int across, int cellSide)
{
    // The texel's middle, in units of 1 / (2 * side) of a cell.
    const auto halves = (2 * std::int64_t{at} + 1) * across;
    const std::int64_t whole = 2 * std::int64_t{side};
    return {.cell = static_cast<int>(halves / whole), .texel = static_cast<int>(halves % whole * cellSide / whole)};
}

/// The rasters of all cells as one; `cells` is null where none was read, and unpainted there.
sim::TiledRaster joined(const std::vector<const sim::TiledRaster*>& cells, const UvTiles& tiles, const MapSpec& spec,
                        int side)
{
    const int across = tiles.across();
    const int cellSide = tiles.imageSideFor(side);
    sim::Texel empty = spec.defaultValue;
    empty[static_cast<std::size_t>(spec.valueChannels)] = 0;
    std::vector<InCell> columns;
    columns.reserve(static_cast<std::size_t>(side));
    for (int x = 0; x < side; ++x)
        columns.push_back(inCell(x, side, across, cellSide));
    const auto readRow = [&](int y, std::span<sim::Texel> texels) {
        const InCell& row = columns[static_cast<std::size_t>(y)];
        for (std::size_t x = 0; x < texels.size(); ++x) {
            const auto cell = static_cast<std::size_t>(across - 1 - row.cell) * static_cast<std::size_t>(across) +
                              static_cast<std::size_t>(columns[x].cell);
            const sim::TiledRaster* own = cell < cells.size() ? cells[cell] : nullptr;
            texels[x] = own != nullptr ? own->texel(columns[x].texel, row.texel) : empty;
        }
    };
    return resampleNearest(side, side, readRow, side, spec.layerChannels());
}

} // namespace

Result<MapSource> mapSourceFrom(ImporterClient& client, const QString& path, const MapSpec& spec, const UvTiles& tiles,
                                const Progress& progress)
{
    if (isTilePattern(path))
        return tilesFrom(client, path, spec, tiles, progress);
    Result<ForeignImage> image = imageForMap(client, path, spec, progress);
    if (!image)
        return tl::unexpected(image.error());
    MapSource source{.images = {}, .cells = {}, .tiles = {}, .leftOut = {}};
    source.images.push_back(std::move(*image));
    return source;
}

ImageReading readingOf(const MapSource& source, const MapSpec& spec)
{
    std::optional<ImageReading> together;
    for (const ForeignImage& image : source.images) {
        // What is white all over tells nothing where other tiles have colours or greys.
        if (std::ranges::all_of(image.pixels, [](std::uint16_t value) { return value == 65535; }))
            continue;
        const ImageReading own = readingOf(image.pixels, image.channels, spec);
        if (own == ImageReading::Scale)
            return own;
        if (!together || own == ImageReading::Value)
            together = own;
    }
    const ForeignImage& first = source.images.front();
    return together ? *together : readingOf(first.pixels, first.channels, spec);
}

Result<ImageLayer> layerFromSource(const MapSource& source, const MapSpec& spec, bool grey, int size)
{
    if (source.cells.empty())
        return layerFromImage(source.images.front(), spec, grey, size).map([&](sim::TiledRaster raster) {
            return ImageLayer{.raster = std::move(raster),
                              .imageSize = {source.images.front().width, source.images.front().height}};
        });
    int wanted = 0;
    for (const ForeignImage& image : source.images)
        wanted = std::max(wanted, source.tiles.mapSideFor(mapSideOf(image)));
    const int side = size != 0 ? size : wanted;
    std::vector<sim::TiledRaster> layers;
    layers.reserve(source.images.size());
    std::vector<const sim::TiledRaster*> byCell(source.tiles.numbers().size(), nullptr);
    for (std::size_t i = 0; i < source.images.size(); ++i) {
        Result<sim::TiledRaster> layer = layerFromImage(source.images[i], spec, grey, source.tiles.imageSideFor(side));
        if (!layer)
            return tl::unexpected(layer.error());
        layers.push_back(std::move(*layer));
        byCell[source.cells[i]] = &layers.back();
    }
    return ImageLayer{.raster = joined(byCell, source.tiles, spec, side), .imageSize = {wanted, wanted}};
}

Result<ImageLayer> layerFromPath(ImporterClient& client, const QString& path, const MapSpec& spec,
                                 std::optional<bool> grey, const UvTiles& tiles, std::vector<int>* leftOut)
{
    return withinMemory(path, cannotOpen, [&]() -> Result<ImageLayer> {
        const Result<MapSource> source = mapSourceFrom(client, path, spec, tiles);
        if (!source)
            return tl::unexpected(source.error());
        if (leftOut != nullptr)
            *leftOut = source->leftOut;
        return layerFromSource(*source, spec, grey.value_or(readingOf(*source, spec) == ImageReading::Value), 0);
    });
}

ForeignImage imageOfCell(const ForeignImage& map, const UvTiles& tiles, std::size_t cell)
{
    const int across = tiles.across();
    const int side = tiles.imageSideFor(map.width);
    const auto column = static_cast<int>(cell) % across;
    const int rowFromTop = across - 1 - static_cast<int>(cell) / across;
    const auto texelOf = [&](int of, int at) { // The other way round than in inCell().
        return static_cast<std::size_t>((2 * (std::int64_t{of} * side + at) + 1) * map.width /
                                        (2 * std::int64_t{side} * across));
    };
    ForeignImage image{
        .width = side, .height = side, .channels = map.channels, .pixels = {}, .areColours = map.areColours};
    const auto channels = static_cast<std::size_t>(map.channels);
    image.pixels.resize(static_cast<std::size_t>(side) * static_cast<std::size_t>(side) * channels);
    auto* to = image.pixels.data();
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const std::size_t from = texelOf(rowFromTop, y) * static_cast<std::size_t>(map.width) + texelOf(column, x);
            to = std::copy_n(map.pixels.data() + from * channels, channels, to);
        }
    return image;
}

QString leftOutTiles(const std::vector<int>& numbers)
{
    if (numbers.empty())
        return {};
    QStringList texts;
    for (const int number : numbers)
        texts.append(QString::number(number));
    return say(QT_TRANSLATE_NOOP("Files", "tiles that the head has not are left out: %1"))
        .arg(texts.join(QStringLiteral(", ")));
}

} // namespace hairpaint::model
