// Maps made visible tile by tile.
#include "model/map_colours.h"

#include "sim/base/parallel.h"

#include <algorithm>

namespace hairpaint::model {

namespace {

sim::Texel colourOf(const std::uint16_t* value, const MapSpec& spec)
{
    if (spec.texel == TexelKind::Colour)
        return {value[0], value[1], value[2], 0};
    const QRgb colour = spec.texel == TexelKind::Index
                            ? spec.palette[std::min<std::size_t>(value[0], spec.palette.size() - 1)].colour
                            : scaleToColour(spec, static_cast<float>(value[0]) / 65535.0F, false);
    const auto wide = [](int channel) { return static_cast<std::uint16_t>(channel * 257); };
    return {wide(qRed(colour)), wide(qGreen(colour)), wide(qBlue(colour)), 0};
}

} // namespace

std::shared_ptr<const sim::TiledRaster> colouredMap(const sim::TiledRaster& resolved, const MapSpec& spec)
{
    auto raster = std::make_shared<sim::TiledRaster>(resolved.size(), 3);
    const auto channels = static_cast<std::size_t>(resolved.channels());
    std::vector<sim::RasterTilePtr> tiles(static_cast<std::size_t>(resolved.tileCount()));
    sim::parallelFor(tiles.size(), 4, [&](std::size_t begin, std::size_t end) {
        for (std::size_t index = begin; index < end; ++index) {
            const sim::RasterTile& from = *resolved.tile(static_cast<int>(index));
            auto tile = std::make_shared<sim::RasterTile>();
            if (from.isUniform())
                tile->uniform = colourOf(from.uniform.data(), spec);
            for (std::size_t at = 0; at < from.pixels.size(); at += channels) {
                const sim::Texel colour = colourOf(from.pixels.data() + at, spec);
                tile->pixels.insert(tile->pixels.end(), colour.begin(), colour.begin() + 3);
            }
            tiles[index] = std::move(tile);
        }
    });
    for (std::size_t index = 0; index < tiles.size(); ++index)
        raster->setTile(static_cast<int>(index), std::move(tiles[index]));
    return raster;
}

} // namespace hairpaint::model
