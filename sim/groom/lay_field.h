// One group's direction map where hair lies: in the cells close over the skin.
#pragma once

#include "sim/groom/lay_kernel.h"
#include "sim/groom/map_slot.h"
#include "sim/groom/tile_index.h"
#include "sim/skin/skin_band.h"

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace hairpaint::sim {

/// One thread writes; any number read between.
class LayField
{
public:
    /// `natural` may be null.
    LayField(std::shared_ptr<const SkinBand> band, MapRaster natural, const MapRaster& direction);

    [[nodiscard]] const std::shared_ptr<const SkinBand>& band() const { return m_band; }
    [[nodiscard]] const MapRaster& natural() const { return m_natural; }
    [[nodiscard]] std::size_t cellCount() const { return m_cells.size(); }
    [[nodiscard]] const LayCell* cells() const { return m_cells.data(); }

    /// How the field changes with another direction map.
    struct Difference
    {
        MapRaster direction;
        std::vector<std::uint32_t> indices; ///< Indices of the cells that differ,
        std::vector<LayCell> cells;         ///< and the cells themselves.
    };
    [[nodiscard]] Difference differenceTo(const MapRaster& direction);
    void apply(const Difference& difference);

private:
    [[nodiscard]] LayCell cellFrom(std::uint32_t index, const TiledRaster& direction) const;
    [[nodiscard]] const TileIndex& tilesFor(int rasterSize);

    std::shared_ptr<const SkinBand> m_band;
    MapRaster m_natural;
    MapRaster m_direction;
    std::vector<LayCell> m_cells;
    std::map<int, TileIndex> m_tiles;
};

} // namespace hairpaint::sim
