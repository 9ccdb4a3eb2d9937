// Pieces of strands on the picture, sorted into its tiles.
#pragma once

#include "view/rendering/software/strand_block.h"

#include <cstdint>
#include <vector>

namespace hairpaint::rendering {

inline constexpr int kTileSp = 32;                  ///< Samples across a tile.
inline constexpr float kWidthUnit = 1.0F / 1900.0F; ///< Samples that a unit of a segment's width stands for.

/// From one point of a strand to the next. Samples; x right, y up.
struct ScreenSegment
{
    float x0, y0, x1, y1;
    std::uint16_t depth0, depth1;
    std::uint16_t width0, width1;   ///< Across its main direction, in kWidthUnit.
    std::uint32_t colour0, colour1; ///< As in StrandPoints.
};

/// That a segment lies in a tile.
struct TileEntry
{
    std::uint32_t segment; ///< Of its batch.
    std::uint16_t depth;   ///< Where it passes the tile's middle.
    std::uint16_t batch;   ///< Its batch; while they are collected, meaningless.
};

struct TileGrid
{
    int across = 0;
    int up = 0;
    int width = 0; ///< Samples.
    int height = 0;
    TileGrid() = default;
    TileGrid(int widthSp, int heightSp)
        : across((widthSp + kTileSp - 1) / kTileSp), up((heightSp + kTileSp - 1) / kTileSp), width(widthSp),
          height(heightSp)
    {}
    [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(across) * static_cast<std::size_t>(up); }
};

/// The segments of a run of strands. What it holds is kept from picture to picture, so that nothing is allocated while
/// the hair moves.
class SegmentBatch
{
public:
    void clear();
    /// The strands of a block, `lanes` of them.
    void add(const TileGrid& tiles, const StrandPoints& points, int segments, std::size_t lanes);
    /// Sorts by tile, in the order in which they came. After that add() needs clear().
    void sort(const TileGrid& tiles);
    [[nodiscard]] const std::vector<ScreenSegment>& segments() const { return m_segments; }
    [[nodiscard]] const TileEntry* begin(std::size_t tile) const { return m_sorted.data() + m_tileBegin[tile]; }
    [[nodiscard]] const TileEntry* end(std::size_t tile) const { return m_sorted.data() + m_tileBegin[tile + 1]; }

private:
    struct Found
    {
        std::uint32_t segment;
        std::uint32_t tile;
        std::uint16_t depth;
    };
    void addToTiles(const TileGrid& tiles, const ScreenSegment& segment);

    std::vector<ScreenSegment> m_segments;
    std::vector<Found> m_found;
    std::vector<TileEntry> m_sorted;
    std::vector<std::uint32_t> m_tileBegin;
};

} // namespace hairpaint::rendering
