// Which roots sample which tiles of a map.
#pragma once

#include "sim/base/tiled_raster.h"

#include <optional>
#include <span>
#include <vector>

namespace hairpaint::sim {

/// The slots, of roots or of anything else with a uv, whose samples begin in each tile of a raster.
class TileIndex
{
public:
    /// O(n): a counting sort.
    TileIndex(std::span<const glm::vec2> uvs, int rasterSize);
    [[nodiscard]] std::span<const std::uint32_t> slotsOf(int tile) const
    {
        const auto at = static_cast<std::size_t>(tile);
        return std::span(m_slots).subspan(m_start[at], m_start[at + 1] - m_start[at]);
    }
    /// The slots of several tiles, tile after tile.
    [[nodiscard]] std::vector<std::uint32_t> slotsOf(std::span<const int> tiles) const;

private:
    std::vector<std::uint32_t> m_start; ///< [tiles + 1]
    std::vector<std::uint32_t> m_slots;
};

/// The tiles in which samples begin that may read texels that differ; none where the rasters are of other shapes or so
/// much differs that every slot is to be looked at. Equal tile pointers are equal tiles.
[[nodiscard]] std::optional<std::vector<int>> tilesThatDiffer(const TiledRaster& before, const TiledRaster& after);

} // namespace hairpaint::sim
