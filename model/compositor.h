// Layers to maps: the arithmetic of resolving, and a cache that resolves again only the tiles that differ.
#pragma once

#include "model/project.h"
#include "model/texel_math.h"

#include <memory>
#include <span>
#include <vector>

namespace hairpaint::model {

/// One texel of a stack. From the spec's default, layer by layer from the bottom, for visible layers:
/// `share = mul16(coverage, unit16(opacity))`; scalars and colours: `lerp16(below, blended, share)` with
/// `blended` by the mode's formula (blend_modes.h); an index replaces where share >= kHalfCoverage.
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
