// What an edit of the document touched, as the document tells of it.
#pragma once

#include "model/project/map_spec.h"

#include <compare>
#include <cstdint>
#include <vector>

namespace hairpaint::model {

using Id = int; ///< Unique within the project, from a counter that its file keeps; 0 is none.

struct LayerAddress
{
    Id group = 0;
    MapKind map = MapKind::Density;
    Id layer = 0;
    // The compared 0 of a defaulted order is no pointer, whatever clang-tidy 14 takes it for.
    friend auto operator<=>(const LayerAddress&, const LayerAddress&) = default; // NOLINT(modernize-use-nullptr)
};

/// What one edit touched. `aspect` says which of the other members mean something.
struct Change
{
    enum class Aspect : std::uint8_t
    {
        Texels,      ///< group, map, layer, tiles
        Resolved,    ///< group, map: what its layers give together has come; an earlier change told why
        LayerList,   ///< group, map: layers added, removed, moved, renamed, or their properties; the map's size
        GroupList,   ///< groups added, removed, renamed, reordered, shown; what is worn in their hair
        Settings,    ///< group: its settings
        Environment, ///< wind, light, background, skin, what is worn
        Head,
        Everything ///< another project
    };
    Aspect aspect = Aspect::Everything;
    Id group = 0;
    MapKind map = MapKind::Density;
    Id layer = 0;
    std::vector<int> tiles = {}; ///< Tiles of the map's raster that changed, ascending; with Texels, empty means all.
    bool preview = false;        ///< Whether the change is a preview, or takes one back.
};

} // namespace hairpaint::model
