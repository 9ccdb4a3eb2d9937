// A tile that is drawn into, and what of it can still be seen through.
#if defined(HAIRPAINT_RENDERING_TILE_CANVAS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_RENDERING_TILE_CANVAS_INL_H_
#undef HAIRPAINT_RENDERING_TILE_CANVAS_INL_H_
#else
#define HAIRPAINT_RENDERING_TILE_CANVAS_INL_H_
#endif

#include "view/rendering/light/lanes_inl.h"
#include "view/rendering/software/tile_kernel.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace hairpaint::rendering::HWY_NAMESPACE {

inline constexpr unsigned kCellSamples = kCellSp * kCellSp;

/// What segments of hair are drawn into.
struct Canvas
{
    const TileTask& task;
    TileSamples& samples;
    int openCells; ///< Cells of the tile that are not known to be opaque.
};

/// Whether all of a cell is opaque. What was opaque stays so, so that no sample is asked about twice once it is.
HWY_INLINE bool isOpaque(Canvas& canvas, unsigned cellX, unsigned cellY)
{
    std::uint8_t& firstOpen = canvas.samples.firstOpen[cellY][cellX];
    if (firstOpen == kCellSamples)
        return true;
    const float* light = canvas.samples.light.data() + 4UL * ((cellY * kCellSp + 1) * kTileRow + cellX * kCellSp + 1);
    for (unsigned n = firstOpen; n < kCellSamples; ++n)
        if (light[4 * (n / kCellSp * kTileRow + n % kCellSp) + 3] >= canvas.task.opaque) {
            firstOpen = static_cast<std::uint8_t>(n);
            return false;
        }
    firstOpen = kCellSamples;
    --canvas.openCells;
    return true;
}

/// Part of a strand's cover that counts where the head may lie in front.
HWY_INLINE float coverBeforeHead(const Canvas& canvas, int x, int y, float depth, float cover)
{
    if (depth <= canvas.samples.headDepth[static_cast<std::size_t>(inTile(x, y))])
        return cover;
    if (x < 0 || y < 0 || x >= canvas.task.width || y >= canvas.task.height)
        return 0.0F;
    const std::size_t at = static_cast<std::size_t>(y) * canvas.task.headStride + static_cast<std::size_t>(x);
    return cover * (1.0F - static_cast<float>(canvas.task.head[at].cover) * (1.0F / 65535.0F));
}

/// Whether all cells that the walk may touch between two positions along its main direction are opaque, or with kHead
/// lie behind the head. `nearest`: the walk's least depth.
template<bool kSteep, bool kHead>
HWY_INLINE bool isClosed(Canvas& canvas, unsigned cell, float from, float to, float reach, float nearest)
{
    const float low = std::min(from, to) - reach;
    const float high = std::max(from, to) + reach;
    if (!(high > 0.0F && low < static_cast<float>(kTileSp)))
        return true;
    constexpr auto kLast = static_cast<float>(kTileSp - 1);
    const unsigned first = static_cast<unsigned>(static_cast<int>(std::max(low, 0.0F))) / kCellSp;
    const unsigned last = static_cast<unsigned>(static_cast<int>(std::min(high, kLast))) / kCellSp;
    for (unsigned c = first; c <= last; ++c) {
        const unsigned x = kSteep ? c : cell;
        const unsigned y = kSteep ? cell : c;
        if constexpr (kHead)
            if (nearest > canvas.samples.hiddenBeyond[y][x])
                continue;
        if (!isOpaque(canvas, x, y))
            return false;
    }
    return true;
}

} // namespace hairpaint::rendering::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
