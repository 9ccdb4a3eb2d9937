// Maps made visible tile by tile.
#include "model/map_colours.h"

#include "model/texel_math.h"
#include "model/texel_ops.h"
#include "sim/base/parallel.h"

namespace hairpaint::model {

std::shared_ptr<const sim::TiledRaster> colouredMap(const sim::TiledRaster& resolved, const MapSpec& spec)
{
    auto raster = std::make_shared<sim::TiledRaster>(resolved.size(), 3);
    const auto channels = static_cast<std::size_t>(resolved.channels());
    std::vector<sim::RasterTilePtr> tiles(static_cast<std::size_t>(resolved.tileCount()));
    sim::parallelFor(tiles.size(), 4, [&](std::size_t begin, std::size_t end) {
        for (std::size_t index = begin; index < end; ++index) {
            const sim::RasterTile& from = *resolved.tile(static_cast<int>(index));
            auto tile = std::make_shared<sim::RasterTile>();
            if (from.isUniform()) {
                texelOps(spec).toColours(spec, false, from.uniform.data(), 0, 1, tile->uniform.data());
            } else {
                tile->pixels.resize(kTileTexels * 3);
                texelOps(spec).toColours(spec, false, from.pixels.data(), channels, kTileTexels, tile->pixels.data());
            }
            tiles[index] = std::move(tile);
        }
    });
    for (std::size_t index = 0; index < tiles.size(); ++index)
        raster->setTile(static_cast<int>(index), std::move(tiles[index]));
    return raster;
}

} // namespace hairpaint::model
