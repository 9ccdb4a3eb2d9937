// One group's direction map where hair lies: in the cells close over the skin.
#pragma once

#include "sim/groom/direction_texel.h"
#include "sim/groom/map_slot.h"
#include "sim/groom/tile_index.h"
#include "sim/skin/skin_band.h"

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace hairpaint::sim {

/// In which direction hair grows: along the skin, and the cosine of its angle to it.
struct Growth
{
    glm::vec3 alongHd{0.0F}; ///< Unit; of no length where hair stands upright.
    float flatness = 0.0F;   ///< 0..1
    friend bool operator==(const Growth&, const Growth&) = default;
};

/// The same at a place, by how long the hair is.
struct GrowthDirections
{
    Growth grown;  ///< As painted, or natural.
    Growth fallen; ///< Of long hair: where nobody combed, to its own side of the middle.

    /// `falls`: fallFraction() of the hair's length.
    [[nodiscard]] Growth of(float falls) const
    {
        return falls <= 0.0F ? grown : falls >= 1.0F ? fallen : between(falls);
    }
    friend bool operator==(const GrowthDirections&, const GrowthDirections&) = default;

private:
    [[nodiscard]] Growth between(float falls) const;
};

/// How far hair of a length lies as it falls rather than as it grows, 0..1.
[[nodiscard]] float fallFraction(float lengthM);

/// Of what the map and the head's natural stream (null where there is none) hold for a place on the skin.
[[nodiscard]] GrowthDirections growthDirections(DirectionVector painted, const DirectionVector* natural,
                                                glm::vec3 positionHd, const SkinFrame& frame);

/// One thread writes; any number read between.
class LayField
{
public:
    struct Cell
    {
        glm::vec3 positionHd{0.0F}; ///< On the skin.
        glm::vec3 normalHd{0.0F};   ///< Unit.
        GrowthDirections directions;

        /// Height over the skin, taken as flat here.
        [[nodiscard]] float heightM(glm::vec3 placeHd) const { return glm::dot(placeHd - positionHd, normalHd); }
    };

    /// `natural` may be null.
    LayField(std::shared_ptr<const SkinBand> band, MapRaster natural, const MapRaster& direction);

    [[nodiscard]] const std::shared_ptr<const SkinBand>& band() const { return m_band; }
    [[nodiscard]] const MapRaster& natural() const { return m_natural; }
    [[nodiscard]] std::size_t cellCount() const { return m_cells.size(); }
    /// SkinBand::kNone further from the skin.
    [[nodiscard]] std::uint32_t indexAt(glm::vec3 placeHd) const { return m_band->indexAt(placeHd); }
    [[nodiscard]] const Cell& operator[](std::uint32_t index) const { return m_cells[index]; }

    /// What another direction map makes of it.
    struct Difference
    {
        MapRaster direction;
        std::vector<std::uint32_t> indices; ///< Of the cells that differ,
        std::vector<Cell> cells;            ///< and they.
    };
    [[nodiscard]] Difference differenceTo(const MapRaster& direction);
    void apply(const Difference& difference);

private:
    [[nodiscard]] Cell cellFrom(std::uint32_t index, const TiledRaster& direction) const;
    [[nodiscard]] const TileIndex& tilesFor(int rasterSize);

    std::shared_ptr<const SkinBand> m_band;
    MapRaster m_natural;
    MapRaster m_direction;
    std::vector<Cell> m_cells;
    std::map<int, TileIndex> m_tiles;
};

} // namespace hairpaint::sim
