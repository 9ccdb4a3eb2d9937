// Layers to maps: the arithmetic of resolving, and a cache that resolves again only the tiles that differ.
#pragma once

#include "model/project.h"

#include <memory>
#include <span>
#include <vector>

namespace hairpaint::model {

/// round(a * b / 65535), exactly.
[[nodiscard]] constexpr std::uint16_t mul16(std::uint32_t a, std::uint32_t b)
{
    const std::uint32_t product = a * b + 32768U;
    return static_cast<std::uint16_t>((product + (product >> 16U)) >> 16U);
}

/// round((below * (65535 - share) + above * share) / 65535), exactly: 0 gives below, 65535 gives above.
[[nodiscard]] constexpr std::uint16_t lerp16(std::uint32_t below, std::uint32_t above, std::uint32_t share)
{
    const std::uint32_t sum = below * (65535U - share) + above * share + 32768U;
    return static_cast<std::uint16_t>((sum + (sum >> 16U)) >> 16U);
}

/// 0..1 as 0..65535, to the nearest.
[[nodiscard]] std::uint16_t unit16(float value);

/// An index replaces where coverage * opacity is at least this.
inline constexpr std::uint16_t kHalfCoverage = 32768;

/// One texel of a stack. From the spec's default, layer by layer from the bottom, for visible layers:
/// `share = mul16(coverage, unit16(opacity))`; scalars and colours: `lerp16(below, blended, share)` with
/// `blended = value` (Normal) or `mul16(below, value)` (Multiply); an index replaces where share >= kHalfCoverage.
[[nodiscard]] sim::Texel resolveTexel(const MapStack& stack, int x, int y);

/// The same for a whole stack: `spec.valueChannels` channels.
[[nodiscard]] sim::TiledRaster resolveStack(const MapStack& stack);

/// A stack and its resolved map. What a caller got from `result()` never changes.
class ResolvedMap
{
public:
    explicit ResolvedMap(const MapStack& stack);

    [[nodiscard]] const std::shared_ptr<const sim::TiledRaster>& result() const { return m_result; }
    /// Resolves again what differs from the stack seen last; a tile whose texels come out the same keeps its pointer.
    /// False where no texel differs.
    bool update(const MapStack& stack);
    /// The same, where only these tiles of one layer can differ: work in proportion to the tiles.
    bool updateTiles(const MapStack& stack, Id layer, std::span<const int> tiles);

private:
    bool resolveTiles(std::span<const int> tiles);

    MapStack m_seen;
    std::shared_ptr<const sim::TiledRaster> m_result;
};

} // namespace hairpaint::model
