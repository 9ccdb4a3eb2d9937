// One tile of the picture: hair laid over it from the nearest on, then the head and the background behind.
#pragma once

#include "view/rendering/software/screen_segments.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace hairpaint::rendering {

/// The head's light and depth at a sample.
struct HeadSample
{
    std::uint16_t red = 0; ///< Square roots of the linear colour, 0..65535.
    std::uint16_t green = 0;
    std::uint16_t blue = 0;
    std::uint16_t cover = 0; ///< Fraction of the sample that the head covers, 0..65535.
};

/// How far behind the head's surface hair is shown, m: hair that lies flat dips into the skin here and there, but what
/// is worn hides the hair that it presses down.
[[nodiscard]] constexpr float hairShownBehindM(bool isWorn)
{
    constexpr float kSkinDepthM = 0.015F;
    constexpr float kWornDepthM = 0.0005F;
    return isWorn ? kWornDepthM : kSkinDepthM;
}

inline constexpr int kTileRow = kTileSp + 2; ///< A tile's samples with one more around it, which is never seen.

/// Index of a sample in an array of kTileRow rows.
[[nodiscard]] constexpr int inTile(int x, int y)
{
    return (y + 1) * kTileRow + x + 1;
}

/// Samples of a tile; rows of kTileRow from the lowest on. Kept by each thread.
struct TileSamples
{
    /// Linear light of hair so far, and what is left to see through.
    alignas(64) std::array<float, 4UL * kTileRow * kTileRow> light;
    /// The first sample of a cell that is not known to be opaque, counted along the cell's rows.
    std::array<std::array<std::uint8_t, kCells>, kCells> firstOpen;
    /// Copies of what the entries' pieces belong to: in the order of depths, neighbours lie far apart in their batches.
    std::vector<ScreenSegment> segments;
    std::vector<TileEntry> entries;
    std::vector<TileEntry> sorted;
    static constexpr unsigned kBucketBits = 11; ///< Of a depth's 16; sorting by the others goes before.
    std::array<std::uint32_t, 1U << kBucketBits> buckets;
    std::array<std::uint32_t, 1U << (16U - kBucketBits)> lowBuckets;
    std::array<float, 1UL * kTileRow * kTileRow> headDepth; ///< Depth a little behind the skin, in segments' units.
    /// The same by cells: beyond it the head covers all of a cell.
    std::array<std::array<float, kCells>, kCells> hiddenBeyond;
};

struct TileTask
{
    int x0 = 0; ///< The tile's corner in the picture, samples.
    int y0 = 0;
    int width = 0; ///< Less than kTileSp at the picture's edges.
    int height = 0;
    bool anyHead = false;
    bool bare = false;                    ///< Nothing but background is wanted: the samples are not looked at.
    const float* headDistanceM = nullptr; ///< The corner's distance, then as `head`; huge where there is no head.
    const std::uint8_t* worn = nullptr;   ///< The corner's, then as `head`: 1 where a solid is seen; null: nowhere.
    const HeadSample* head = nullptr;     ///< The corner's sample; rows are headStride apart.
    std::size_t headStride = 0;           ///< From a row to the one above.
    float opaque = 0.02F;                 ///< A sample counts as opaque where less than this is left to see through.
    float nearestM = 0.0F;                ///< Distance at which the segments' depths begin.
    float depthsPerM = 0.0F;
};

/// Lays `samples.entries` over the tile, nearest first. Fills samples.light.
void layHair(const TileTask& task, TileSamples& samples);

} // namespace hairpaint::rendering
