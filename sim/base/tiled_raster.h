// A square image of 16-bit channels in copy-on-write tiles: layers, stroke scratch and resolved maps are all of this
// type.
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace hairpaint::sim {

using Texel = std::array<std::uint16_t, 4>; ///< Channels that a raster does not have are 0.

/// 64 x 64 texels, interleaved, row 0 at v = 1. A uniform tile holds no pixels.
struct RasterTile
{
    Texel uniform{};
    std::vector<std::uint16_t> pixels; ///< Empty, or [64][64][channels].
    [[nodiscard]] bool isUniform() const { return pixels.empty(); }
};
using RasterTilePtr = std::shared_ptr<const RasterTile>;
inline constexpr std::size_t kTileTexels = std::size_t{64} * 64;

/// The value of every texel of [64][64][channels] where they are all equal.
[[nodiscard]] std::optional<Texel> commonTexel(std::span<const std::uint16_t> pixels);
/// The tile's texels as pixels, whether it holds them or not.
[[nodiscard]] std::vector<std::uint16_t> expanded(const RasterTile& tile, int channels);
/// The same texels, as one value where they are all equal.
[[nodiscard]] RasterTile folded(RasterTile tile);
/// Whether two tiles have equal texels, however either of them is stored.
[[nodiscard]] bool sameTexels(const RasterTile& a, const RasterTile& b);

/// Half-open rectangle of texels.
struct TexelRect
{
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    [[nodiscard]] bool empty() const { return x0 >= x1 || y0 >= y1; }
    friend bool operator==(const TexelRect&, const TexelRect&) = default;
};

/// Copying shares every tile; writing detaches the tiles written. Copies may be read on other threads while this one is
/// written. Equal tile pointers mean equal texels, which is how the groom finds what changed.
class TiledRaster
{
public:
    static constexpr int kTileSize = 64;
    static constexpr int kSmallestSize = 256;
    static constexpr int kLargestSize = 8192;

    /// `size`: texels a side, a power of two of 64 or more; `channels`: 1 to 4.
    TiledRaster(int size, int channels, Texel fill = {});

    [[nodiscard]] int size() const { return m_size; }
    [[nodiscard]] int channels() const { return m_channels; }
    [[nodiscard]] int tilesAcross() const { return m_tilesAcross; }
    [[nodiscard]] TexelRect bounds() const { return {0, 0, m_size, m_size}; }
    [[nodiscard]] TexelRect tileRect(int tileIndex) const;

    /// Tiles are numbered row by row from the one that holds texel (0, 0).
    [[nodiscard]] int tileCount() const { return static_cast<int>(m_tiles.size()); }
    [[nodiscard]] int tileIndexAt(int x, int y) const { return (y / kTileSize) * m_tilesAcross + x / kTileSize; }
    [[nodiscard]] const RasterTilePtr& tile(int tileIndex) const
    {
        return m_tiles[static_cast<std::size_t>(tileIndex)];
    }
    void setTile(int tileIndex, RasterTilePtr tile);
    void setUniform(int tileIndex, Texel value);
    /// The tile's own pixels, [64][64][channels], detached and expanded first where needed.
    [[nodiscard]] std::span<std::uint16_t> writableTile(int tileIndex);
    /// Turns a tile whose texels are all equal back into a uniform one.
    void compact(int tileIndex);

    [[nodiscard]] Texel texel(int x, int y) const;
    void setTexel(int x, int y, Texel value);

    /// Bilinear at a uv (clamped; not a number is 0), each channel 0..1; exact between equal texels. Texel centres at
    /// (i + 1/2)/size, row 0 at v = 1.
    [[nodiscard]] glm::vec4 sampleBilinear(glm::vec2 uv) const;
    /// The first channel of sampleBilinear.
    [[nodiscard]] float sampleScalar(glm::vec2 uv) const;
    /// The four texels that sampleBilinear() mixes.
    struct Neighbours
    {
        std::array<Texel, 4> texels{};
        std::array<float, 4> weights{}; ///< Sum to 1.
    };
    [[nodiscard]] Neighbours neighbours(glm::vec2 uv) const;
    [[nodiscard]] Texel sampleNearest(glm::vec2 uv) const;
    /// The upper left one of the four texels that sampleBilinear reads; the others are its neighbours.
    /// sampleNearest reads one of them.
    [[nodiscard]] static glm::ivec2 footprint(glm::vec2 uv, int size);
    /// The value of every texel where all tiles are uniform and equal; not searched for inside tiles that hold pixels.
    [[nodiscard]] std::optional<Texel> uniformValue() const;

    /// Bytes of pixels held by this raster, counting shared tiles in full.
    [[nodiscard]] std::size_t byteCount() const;

    friend bool operator==(const TiledRaster& a, const TiledRaster& b); ///< Compares texels.

private:
    [[nodiscard]] const std::uint16_t* channelsAt(int x, int y) const; ///< The channels of one texel.
    /// The channels of four neighbours: first, to its right, below it, last.
    [[nodiscard]] std::array<const std::uint16_t*, 4> corners(glm::ivec2 first, glm::ivec2 last) const;

    int m_size;
    int m_channels;
    int m_tilesAcross;
    std::vector<RasterTilePtr> m_tiles;
};

} // namespace hairpaint::sim
