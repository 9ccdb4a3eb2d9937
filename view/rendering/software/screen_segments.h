// Pieces of strands on the picture, sorted into its tiles.
#pragma once

#include "view/rendering/software/strand_block.h"

#include <array>
#include <cstdint>
#include <vector>

namespace hairpaint::rendering {

inline constexpr int kTileSp = 32; ///< Samples across a tile,
inline constexpr int kCellSp = 8;  ///< and across a cell of it.
inline constexpr int kCells = kTileSp / kCellSp;
inline constexpr float kWidthUnit = 1.0F / 1900.0F; ///< Samples that a unit of a segment's width stands for.

/// From one point of a strand to the next. Samples; x right, y up.
struct alignas(32) ScreenSegment
{
    float x0, y0, x1, y1;
    std::array<std::uint16_t, 2> depth;
    std::array<std::uint16_t, 2> width;  ///< Across its main direction, in kWidthUnit.
    std::array<std::uint32_t, 2> colour; ///< As in StrandPoints.
};

/// Tiles, depths and widths of the segments of a block. Rows [segment][kBlockLanes].
struct SegmentBounds
{
    std::vector<std::uint32_t> lanes;  ///< [segment], a bit a lane: those that are seen in the picture.
    std::vector<std::uint32_t> tilesX; ///< The first tile touched, and in the upper half the last.
    std::vector<std::uint32_t> tilesY;
    /// Both of ScreenSegment::depth, the first in the lower half; `widths` likewise.
    std::vector<std::uint32_t> depths;
    std::vector<std::uint32_t> widths;
    void resize(std::size_t segments);
};

/// A piece of a segment: the part in cells of one tile that follow each other along its main direction.
struct SegmentPiece
{
    static constexpr unsigned kNumberBits = 28;
    std::uint32_t bits; ///< The segment's number in its list, the first cell in two bits, the last in two.
    [[nodiscard]] static SegmentPiece of(std::uint32_t segment, int firstCell, int lastCell)
    {
        return {segment | static_cast<std::uint32_t>(firstCell) << kNumberBits |
                static_cast<std::uint32_t>(lastCell) << (kNumberBits + 2)};
    }
    [[nodiscard]] std::uint32_t segment() const { return bits & ((1U << kNumberBits) - 1); }
    [[nodiscard]] int firstCell() const { return static_cast<int>((bits >> kNumberBits) & 3U); }
    [[nodiscard]] int lastCell() const { return static_cast<int>(bits >> (kNumberBits + 2)); }
    /// The same piece where the segment stands in another list.
    [[nodiscard]] SegmentPiece renumbered(std::uint32_t segment) const
    {
        return {(bits & ~((1U << kNumberBits) - 1)) | segment};
    }
};
static_assert(kCells == 4);

/// That a piece lies in a tile.
struct TileEntry
{
    SegmentPiece piece;
    std::uint32_t depth; ///< Depth of its middle, 0..65535.
};

struct TileGrid
{
    int across = 0;
    int up = 0;
    int width = 0; ///< Samples.
    int height = 0;
    int firstUp = 0;         ///< First row of tiles that is drawn,
    int endUp = 0;           ///< and the row behind the last.
    float evenDepths = 0.0F; ///< A segment whose depths in a tile differ by more is cut at the cells.
    TileGrid() = default;
    TileGrid(int widthSp, int heightSp, float evenDepthsWanted)
        : across((widthSp + kTileSp - 1) / kTileSp), up((heightSp + kTileSp - 1) / kTileSp), width(widthSp),
          height(heightSp), endUp(up), evenDepths(evenDepthsWanted)
    {}
    [[nodiscard]] int rows() const { return endUp - firstUp; }
    /// Number of tiles in the rows that are drawn; number() counts from the first of them.
    [[nodiscard]] std::size_t count() const
    {
        return static_cast<std::size_t>(across) * static_cast<std::size_t>(rows());
    }
    [[nodiscard]] std::size_t number(int x, int y) const
    {
        return static_cast<std::size_t>(y - firstUp) * static_cast<std::size_t>(across) + static_cast<std::size_t>(x);
    }
};

/// What a batch is made with; a thread keeps it from batch to batch.
struct SegmentScratch
{
    /// That a piece lies in a tile.
    struct Found
    {
        SegmentPiece piece;
        std::uint32_t tile;
        std::uint16_t depth;
    };
    SegmentBounds bounds;
    std::vector<Found> found; ///< Never shrinks; the first foundCount are in use.
    std::size_t foundCount = 0;
};

/// The segments of a run of strands. What it holds is kept from picture to picture, so that nothing is allocated while
/// the hair moves; what few pictures needed is freed after kPicturesKept.
class SegmentBatch
{
public:
    static constexpr int kPicturesKept = 64;

    void clear(); ///< Before each picture.
    /// Adds the segments of a block of strands.
    void add(const TileGrid& tiles, const StrandPoints& points, int segments, SegmentScratch& scratch);
    /// Sorts the pieces by tile, in the order in which they were added. After that the scratch is free, and clear()
    /// must be called before add().
    void sort(const TileGrid& tiles, SegmentScratch& scratch);
    [[nodiscard]] const ScreenSegment* segments() const { return m_segments.data(); }
    [[nodiscard]] const TileEntry* begin(std::size_t tile) const { return m_sorted.data() + m_tileBegin[tile]; }
    [[nodiscard]] const TileEntry* end(std::size_t tile) const { return m_sorted.data() + m_tileBegin[tile + 1]; }
    [[nodiscard]] std::size_t heldBytes() const; ///< Bytes held for segments and entries of tiles.
    [[nodiscard]] std::size_t usedBytes() const; ///< Bytes of these that this picture uses.

private:
    void addToTile(const TileGrid& tiles, const ScreenSegment& segment, int tileX, int tileY, SegmentScratch& scratch);
    void addToTiles(const TileGrid& tiles, const ScreenSegment& segment, std::uint32_t tilesX, std::uint32_t tilesY,
                    SegmentScratch& scratch);

    std::vector<ScreenSegment> m_segments; ///< The first m_segmentCount are in use; shrinks only after kPicturesKept.
    std::size_t m_segmentCount = 0;
    std::vector<TileEntry> m_sorted; ///< The first m_sortedCount are in use.
    std::size_t m_sortedCount = 0;
    std::vector<std::uint32_t> m_tileBegin;
    std::size_t m_mostSegments = 0; ///< Greatest number in a picture since memory was last freed.
    std::size_t m_mostSorted = 0;
    int m_pictures = 0;
};

} // namespace hairpaint::rendering
