// Paint on one tile.
#include "model/tools/tile_paint.h"

#include "model/texel_math.h"

#include <algorithm>

namespace hairpaint::model {

namespace {

void expand(sim::RasterTile& tile, const sim::RasterTile& from, std::size_t channels)
{
    if (!from.isUniform()) {
        tile.pixels = from.pixels;
        return;
    }
    tile.pixels.resize(kTileTexels * channels);
    for (std::size_t i = 0; i < tile.pixels.size(); ++i)
        tile.pixels[i] = from.uniform[i % channels];
}

} // namespace

sim::RasterTilePtr paintTile(const MapSpec& spec, const sim::RasterTilePtr& before, const StrokeBuffer::MaskTile& mask,
                             const TilePaint& paint)
{
    const auto channels = static_cast<std::size_t>(spec.layerChannels());
    auto tile = std::make_shared<sim::RasterTile>();
    expand(*tile, *before, channels);
    std::uint16_t* pixels = tile->pixels.data();
    if (paint.erase)
        texelOps(spec).erase(spec, pixels, mask.data(), paint.opacity);
    else
        texelOps(spec).lay(pixels, mask.data(), paint);

    const auto stride = static_cast<std::ptrdiff_t>(channels);
    if (std::equal(tile->pixels.begin() + stride, tile->pixels.end(), tile->pixels.begin())) {
        std::copy_n(tile->pixels.begin(), channels, tile->uniform.begin());
        tile->pixels = {};
    }
    const bool same =
        tile->isUniform() == before->isUniform() && tile->uniform == before->uniform && tile->pixels == before->pixels;
    return same ? before : tile;
}

} // namespace hairpaint::model
