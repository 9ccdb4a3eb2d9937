// Paint on one tile.
#include "model/maps/tile_paint.h"

namespace hairpaint::model {

sim::RasterTilePtr paintTile(const MapSpec& spec, const sim::RasterTilePtr& before, const MaskTile& mask,
                             const TilePaint& paint)
{
    sim::RasterTile tile;
    tile.pixels = sim::expanded(*before, spec.layerChannels());
    if (paint.erase)
        texelOps(spec).erase(spec, tile.pixels.data(), mask.data(), paint.opacity);
    else
        texelOps(spec).lay(tile.pixels.data(), mask.data(), paint);
    tile = sim::folded(std::move(tile));
    return sim::sameTexels(tile, *before) ? before : std::make_shared<const sim::RasterTile>(std::move(tile));
}

} // namespace hairpaint::model
