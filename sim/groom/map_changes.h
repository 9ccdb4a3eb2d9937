// Finds the candidates whose map values differ between two snapshots, from the tiles that differ.
#pragma once

#include "sim/groom/groom_input.h"
#include "sim/groom/roots.h"
#include "sim/groom/slot_set.h"
#include "sim/groom/tile_index.h"

#include <functional>
#include <map>
#include <memory>

namespace hairpaint::sim {

/// The candidates whose values differ, by what is to be made anew.
struct ChangedSlots
{
    SlotSet hairs;
    SlotSet basis; ///< Basis hairs only.
    SlotSet look;  ///< May also be in `hairs`.

    explicit ChangedSlots(std::size_t slots) : hairs(slots), basis(slots), look(slots) {}
    [[nodiscard]] bool empty() const { return hairs.empty() && basis.empty() && look.empty(); }
};

/// Compares maps at one root set. Keeps an index for every size of raster it has met.
class MapChanges
{
public:
    explicit MapChanges(std::shared_ptr<const RootSet> roots) : m_roots(std::move(roots)) {}

    /// Makes the indices for these maps, which else are made at the first change.
    void prepare(const GroupMaps& maps);
    /// Adds every slot where a value differs to what that map's rule says it has an effect on. Equal tile pointers are
    /// equal tiles; where pointers differ the sampled values decide.
    void find(const GroupMaps& before, const GroupMaps& after, ChangedSlots& changed);

    /// Calls `changed` for each slot whose nearest texel differs; one after the other.
    void findNearest(const TiledRaster& before, const TiledRaster& after,
                     const std::function<void(std::uint32_t)>& changed);

private:
    const TileIndex& indexFor(int rasterSize);
    /// Calls `insert` for the candidates that may read texels that differ and of which `differs` is true; either from
    /// several threads, `insert` from each with chunks of its own.
    template<typename Differs, typename Insert>
    void visitChanged(const TiledRaster& before, const TiledRaster& after, const Differs& differs,
                      const Insert& insert);
    template<typename Read>
    void compare(const MapRule& rule, const Read& read, const MapRaster& before, const MapRaster& after,
                 ChangedSlots& changed);

    std::shared_ptr<const RootSet> m_roots;
    std::map<int, TileIndex> m_indices;
};

} // namespace hairpaint::sim
