// The connected patches of an index map on the skin.
#pragma once

#include "sim/groom/map_slot.h"
#include "sim/skin/skin_islands.h"

#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace hairpaint::sim {

/// The parts of patches in one tile.
struct PatchTile
{
    RasterTilePtr source;
    std::vector<std::uint16_t> kinds;  ///< [parts] the map's value.
    std::vector<std::uint32_t> counts; ///< [parts] number of texels.
    std::vector<std::uint16_t> parts;  ///< [64 * 64] part from 1 on, 0: none; empty where the tile has no part.
};

struct Patch
{
    std::uint16_t kind = 0;
    std::uint32_t texels = 0;
    std::vector<std::pair<int, std::uint16_t>> parts; ///< Tile and part in it, in order.
};

/// Texels of one value other than 0 that touch by an edge on one island, or across a seam, are a patch. Work in
/// proportion to the tiles that differ, and the borders of those that are painted. Copies share what they found.
class PatchLabels
{
public:
    /// Brings it to the map; an other `islands` begins anew.
    void update(const MapRaster& map, const std::shared_ptr<const SkinIslands>& islands);

    [[nodiscard]] std::span<const Patch> patches() const { return m_patches; } ///< Sorted by their first parts.
    [[nodiscard]] const PatchTile& tile(int index) const { return *m_tiles[static_cast<std::size_t>(index)]; }
    [[nodiscard]] const std::shared_ptr<const PatchTile>& tilePointer(int index) const
    {
        return m_tiles[static_cast<std::size_t>(index)];
    }
    [[nodiscard]] int tileCount() const { return static_cast<int>(m_tiles.size()); }
    /// Index into patches() of the patch that a part (from 1 on) of a tile belongs to.
    [[nodiscard]] std::size_t patchOf(int tile, std::uint16_t part) const
    {
        return m_patchOfPart[m_firstPart[static_cast<std::size_t>(tile)] + part - 1U];
    }
    /// The patch that the uv lies in.
    [[nodiscard]] std::optional<std::size_t> at(glm::vec2 uv) const;
    [[nodiscard]] const std::shared_ptr<const SkinIslands>& islands() const { return m_islands; }

private:
    [[nodiscard]] std::shared_ptr<const PatchTile> labelled(int index, const RasterTilePtr& source) const;
    void joinParts();

    std::shared_ptr<const SkinIslands> m_islands;
    MapRaster m_map;
    std::vector<std::shared_ptr<const PatchTile>> m_tiles;
    std::vector<std::uint32_t> m_firstPart; ///< [tiles] index of the tile's part 1 in m_patchOfPart.
    std::vector<std::size_t> m_patchOfPart;
    std::vector<Patch> m_patches;
};

/// Whether both cover the same texels with the same value.
[[nodiscard]] bool samePatch(const PatchLabels& a, std::size_t patchA, const PatchLabels& b, std::size_t patchB);
/// Texels that both cover.
[[nodiscard]] std::uint32_t texelsInBoth(const PatchLabels& a, std::size_t patchA, const PatchLabels& b,
                                         std::size_t patchB);

} // namespace hairpaint::sim
