// Everything the hair depends on, as one immutable snapshot from the document.
#pragma once

#include "sim/groom/group_settings.h"
#include "sim/groom/map_slot.h"
#include "sim/groom/tie.h"
#include "sim/skin/distance_grid.h"
#include "sim/skin/ellipsoid.h"
#include "sim/skin/neck.h"
#include "sim/skin/skin.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace hairpaint::sim {

/// Compared with the one before by pointer and value, so that work is proportional to what differs.
struct GroomInput
{
    struct Group
    {
        int id = 0;
        bool visible = true;
        GroupSettings settings;
        GroupMaps maps;
        std::vector<Tie> ties; ///< Sorted by their numbers.
        /// One channel, read at the nearest texel: the number of the tie that gathers the hair of a root; 0, or a
        /// number that no tie has: loose. Null: none is gathered.
        MapRaster gathered;
    };

    std::shared_ptr<const Skin> skin;
    std::vector<Ellipsoid> colliders;
    std::shared_ptr<const DistanceGrid> distances; ///< To the skin; null: the colliders alone keep hair out of it.
    Neck neck;                                     ///< Shoulders on which hair grows turn with the head all the same.
    MapRaster naturalDirection; ///< How hair grows where nobody combed it; null where that is not known.
    std::vector<Group> groups;
    std::uint64_t seed = 1;
    int maxHairs = 1'000'000;   ///< Limit on candidates over all groups; divided in the groups' order.
    std::uint64_t revision = 0; ///< The document's; frames repeat it. A change of it alone rebuilds nothing.
    bool preview = false;       ///< Holds something not committed yet.
};

} // namespace hairpaint::sim
