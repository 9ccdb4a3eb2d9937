// Layers to maps: the arithmetic of resolving, and a cache that resolves again only the tiles that differ.
// Any thread, one at a time for a ResolvedMap. Errors: none but std::bad_alloc, after which a ResolvedMap may show what
// was before and is to be made anew.
#pragma once

#include "model/project/project.h"
#include "model/values/texel_math.h"

#include <functional>
#include <span>
#include <vector>

namespace hairpaint::model {

/// What a map shows where nothing is painted: null where that is one value, the spec's. `resolved`: the group's maps.
[[nodiscard]] sim::MapRaster startOf(const MapSpec& spec, const Head* head,
                                     const std::function<sim::MapRaster(MapKind)>& resolved);

/// One texel of a stack. From the start's texel (the spec's default where `start` is null; sampled where it has another
/// size), layer by layer from the bottom, for visible layers:
/// `fraction = mul16(coverage, unit16(opacity))`; scalars and colours: `lerp16(below, blended, fraction)` with
/// `blended` by the mode's formula (blend_modes.h); an index replaces where fraction >= kHalfCoverage.
[[nodiscard]] sim::Texel resolveTexel(const MapStack& stack, int x, int y, const sim::MapRaster& start = nullptr);

/// The same for a whole stack: `spec.valueChannels` channels. Shares the start's tiles where no layer shows.
[[nodiscard]] sim::TiledRaster resolveStack(const MapStack& stack, const sim::MapRaster& start = nullptr);

/// What resolving a whole stack takes: the tiles of its layers that are not one value.
[[nodiscard]] std::size_t tilesToBlend(const MapStack& stack);

/// A stack and its resolved map. What a caller got from `result()` never changes.
class ResolvedMap
{
public:
    explicit ResolvedMap(const MapStack& stack, sim::MapRaster start = nullptr);

    /// The start itself where no layer shows and it has the stack's size.
    [[nodiscard]] const sim::MapRaster& result() const { return m_result; }
    /// The same of update().
    [[nodiscard]] std::size_t tilesToBlend(const MapStack& stack, const sim::MapRaster& start = nullptr) const;
    /// Resolves again what differs from the stack and the start seen last; a tile whose texels come out the same keeps
    /// its pointer. False where no texel differs.
    bool update(const MapStack& stack, const sim::MapRaster& start = nullptr);
    /// The same, where only these tiles of one layer can differ: work in proportion to the tiles.
    bool updateTiles(const MapStack& stack, Id layer, std::span<const int> tiles);

private:
    [[nodiscard]] std::vector<int> staleTiles(const MapStack& stack, const sim::MapRaster& start) const;
    bool resolveTiles(std::span<const int> tiles);
    void shareStart();

    MapStack m_seen;
    sim::MapRaster m_start;
    sim::MapRaster m_result;
};

} // namespace hairpaint::model
