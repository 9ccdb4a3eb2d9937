// Which roots sample which tiles of a map.
#pragma once

#include "sim/base/tiled_raster.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace hairpaint::sim {

/// The slots, of roots or of anything else with a uv, by the texels of a raster at which their samples begin (see
/// TiledRaster::footprint).
class TileIndex
{
public:
    /// O(n): a counting sort.
    TileIndex(std::span<const glm::vec2> uvs, int rasterSize);
    /// The slots whose samples begin in one of the rectangles, each of which lies in one tile; rectangle after
    /// rectangle.
    [[nodiscard]] std::vector<std::uint32_t> slotsIn(std::span<const TexelRect> footprints) const;

private:
    struct Entry
    {
        std::uint32_t slot = 0;
        std::uint16_t x = 0; ///< The texel,
        std::uint16_t y = 0; ///< of the raster.
    };
    int m_tilesAcross;
    std::vector<std::uint32_t> m_start; ///< [tiles + 1]
    std::vector<Entry> m_entries;       ///< Tile by tile, slots rising.
};

/// Where samples begin that may read texels that differ: at most one rectangle a tile, in it; none at all where the
/// rasters are of other shapes or so much differs that every slot is to be looked at. Equal tile pointers are equal
/// tiles.
[[nodiscard]] std::optional<std::vector<TexelRect>> footprintsThatDiffer(const TiledRaster& before,
                                                                         const TiledRaster& after);

} // namespace hairpaint::sim
