// How the texels of a map lie on the skin: the islands of its uv layout, and which texels meet across a seam.
#pragma once

#include "sim/base/tiled_raster.h"
#include "sim/skin/skin.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace hairpaint::sim {

/// The islands of one skin in maps of one size. Tiles are computed when they are first asked for: one thread at a time.
class SkinIslands
{
public:
    using Tile = std::array<std::uint16_t, kTileTexels>;
    /// A texel on one side of a seam and one that touches it on the other.
    struct Link
    {
        int tileA = 0, tileB = 0;
        std::uint16_t texelA = 0, texelB = 0;                        ///< Within the tile.
        friend auto operator<=>(const Link&, const Link&) = default; // NOLINT(modernize-use-nullptr)
    };

    SkinIslands(std::shared_ptr<const Skin> skin, int size);

    [[nodiscard]] const std::shared_ptr<const Skin>& skin() const { return m_skin; }
    [[nodiscard]] int size() const { return m_size; }
    /// The island that touches each texel, from 1 on; 0: none.
    [[nodiscard]] const Tile& tile(int index) const;
    [[nodiscard]] std::span<const Link> links() const { return m_links; } ///< In order.

private:
    [[nodiscard]] glm::vec2 texelOf(std::uint32_t vertex) const;
    void findIslands();
    void sortFaces();
    void findLinks();
    void addLinks(glm::uvec2 edgeA, std::uint32_t faceA, glm::uvec2 edgeB, std::uint32_t faceB);

    std::shared_ptr<const Skin> m_skin;
    int m_size;
    int m_tilesAcross;
    std::vector<std::uint16_t> m_islandOfVertex;
    std::vector<std::vector<std::uint32_t>> m_facesOfTile;
    std::vector<Link> m_links;
    mutable std::vector<std::unique_ptr<const Tile>> m_tiles;
};

} // namespace hairpaint::sim
