// Which tile of the uv plane each cell of a head's maps shows. Any thread.
#pragma once

#include <glm/glm.hpp>

#include <optional>
#include <span>
#include <vector>

namespace hairpaint::model {

inline constexpr int kFirstUdim = 1001;
inline constexpr int kLastUdim = 1100;

/// 1001 + column + 10 row, as UDIM counts.
[[nodiscard]] constexpr int udimOf(const glm::ivec2& tile)
{
    return kFirstUdim + tile.x + 10 * tile.y;
}

/// How layout_packing.h laid a head's layouts side by side: in a square of across() x across() cells, rows from the
/// lower left.
class UvTiles
{
public:
    UvTiles() = default; ///< One tile, 1001, which is all of the map.
    /// By cell, each kFirstUdim .. kLastUdim; none: as the default.
    explicit UvTiles(std::vector<int> numbers);

    [[nodiscard]] std::span<const int> numbers() const { return m_numbers; }
    [[nodiscard]] int across() const;
    /// Where the maps are those of tile 1001 as they are.
    [[nodiscard]] bool isOneMap() const { return m_numbers.size() == 1 && m_numbers.front() == kFirstUdim; }
    [[nodiscard]] std::optional<std::size_t> cellOf(int number) const;
    /// A tile that several cells come from, so that no file of one tile can hold them.
    [[nodiscard]] std::optional<int> shared() const;
    /// The side of a tile's image that goes with maps of that side, in pixels: half of it, a quarter or less, so that
    /// every texel of the map has a pixel of its own; at least a map's smallest side.
    [[nodiscard]] int imageSideFor(int mapSide) const;
    /// The other way round; at most a map's greatest side. `imageSide`: a power of two.
    [[nodiscard]] int mapSideFor(int imageSide) const;

    friend bool operator==(const UvTiles&, const UvTiles&) = default;

private:
    std::vector<int> m_numbers{kFirstUdim};
};

} // namespace hairpaint::model
