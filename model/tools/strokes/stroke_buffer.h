// What a running stroke has covered: a 16-bit mask over a map, and the dabs that fill it.
#pragma once

#include "model/maps/tile_paint.h"
#include "sim/base/tiled_raster.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace hairpaint::model {

inline constexpr int kTile = sim::TiledRaster::kTileSize; ///< Side of a tile, texels.

/// One dab: inside where `a dx2 + 2 b dx dy + c dy2 < 1`, dx and dy in texels from the centre, y down.
struct Dab
{
    float xTx = 0.0F, yTx = 0.0F; ///< Texel (0, 0)'s centre is (1/2, 1/2).
    float a = 1.0F, b = 0.0F, c = 1.0F;
    float hardness = 1.0F; ///< 0..1: fraction of the radius that is fully covered.
    float strength = 1.0F; ///< 0..1: coverage at the centre.
};

/// A dab never adds to an earlier one: each texel keeps the greatest mask of all dabs. So neither the order of the dabs
/// nor their overlap shows, and a mirrored stroke meets itself without a seam.
class StrokeBuffer
{
public:
    using MaskTile = model::MaskTile;

    /// `valueChannels`: channels of the values that dabs leave; 0 where all dabs leave the same value.
    explicit StrokeBuffer(int size, int valueChannels = 0);

    /// Paints inside `clip` only. Allocates the tiles it meets first.
    void add(const Dab& dab, const sim::TexelRect& clip);
    /// The same; where no earlier dab is stronger it leaves `value`.
    void add(const Dab& dab, const sim::TexelRect& clip, const sim::Texel& value);

    /// The mask of a tile; null where no dab has been.
    [[nodiscard]] const MaskTile* mask(int tileIndex) const
    {
        return m_tiles[static_cast<std::size_t>(tileIndex)].get();
    }
    /// [64][64][valueChannels], each of meaning where the mask is above 0; null where no dab left a value.
    [[nodiscard]] const std::uint16_t* values(int tileIndex) const
    {
        const std::vector<std::uint16_t>& tile = m_values[static_cast<std::size_t>(tileIndex)];
        return tile.empty() ? nullptr : tile.data();
    }
    /// The mask of a tile, to be written by the tool itself; a new one is zeroed.
    [[nodiscard]] MaskTile& writableMask(int tileIndex);
    /// Tiles touched since the last call, each once, in ascending order.
    [[nodiscard]] std::vector<int> takeDirty();

private:
    /// Texels of one row: [x0, x1) may be covered, [full0, full1) certainly is.
    struct Span
    {
        int x0, x1, full0, full1;
    };
    struct Kernel;
    void add(const Dab& dab, const sim::TexelRect& clip, const sim::Texel* value);
    void layValue(int tileIndex, std::size_t firstTexel, std::span<const std::uint16_t> masks, std::uint16_t* row,
                  const sim::Texel& value);
    void findSpans(const Kernel& kernel, const sim::TexelRect& rect);
    static void addRow(const Kernel& kernel, const Span& span, const sim::TexelRect& clip, int y, int left,
                       std::uint16_t* row);

    int m_size;
    int m_tilesAcross;
    std::size_t m_valueChannels;
    std::vector<std::unique_ptr<MaskTile>> m_tiles;
    std::vector<std::vector<std::uint16_t>> m_values;
    std::vector<bool> m_isDirty;
    std::vector<int> m_dirty;
    std::vector<Span> m_spans; ///< Reused by all dabs, so that a dab does not allocate.
};

} // namespace hairpaint::model
