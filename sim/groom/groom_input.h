// Everything the hair depends on, as one immutable snapshot from the document.
#pragma once

#include "sim/base/tiled_raster.h"
#include "sim/groom/group_settings.h"
#include "sim/skin/ellipsoid.h"
#include "sim/skin/skin.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace hairpaint::sim {

/// Resolved maps of one group. Scalars have 1 channel, braid 1 (0 none, 1 plait, 2 twist, 3 loc), colour 3 (sRGB as
/// encoded). All are present.
struct GroupMaps
{
    std::shared_ptr<const TiledRaster> density, length, curl, braid, colour, clump, gel;
};

struct GroupInput
{
    int id = 0;
    bool visible = true;
    GroupSettings settings;
    GroupMaps maps;
};

/// Compared with the one before by pointer and value, so that work is proportional to what differs.
struct GroomInput
{
    std::shared_ptr<const Skin> skin;
    std::vector<Ellipsoid> colliders;
    std::vector<GroupInput> groups;
    std::uint64_t seed = 1;
    int maxHairs = 1'000'000;   ///< Limit on candidates over all groups; divided in the groups' order.
    std::uint64_t revision = 0; ///< Of the document; frames repeat it. It alone rebuilds nothing.
    bool preview = false;       ///< Holds something not committed yet.
};

} // namespace hairpaint::sim
