// Draws hairs to their locks.
#pragma once

#include "sim/base/strand_blocks.h"
#include "sim/groom/group_settings.h"

#include <array>

namespace hairpaint::sim {

/// kLanes laid hairs and, to each, the basis hair nearest to it. Nodes are [nodes][3][kLanes]. Hd, m.
struct ClumpTask
{
    using Row = std::array<float, kLanes>;
    int nodes = 0;
    float* nodesHd = nullptr;       ///< Changed where they lie; a hair of no clump stays as it is.
    const float* basisHd = nullptr; ///< Ignored where no clump.
    Row segmentM{};
    Row basisSegmentM{};               ///< Not 0 where there is clump.
    LockSettings locks;                ///< Their shape: flatness, twist and parting.
    std::array<Row, 3> leaderNormal{}; ///< Unit, at the basis hair's root; ignored where locks are round.
    Row clump{}; ///< 0..1. Reduced by the angle between the two hairs: across a parting none gathers.
};

/// Draws the nodes toward the basis hair's at the same distance along the hair, by `clump` times a fraction that grows
/// to the tip, and restores the distance of neighbouring nodes. Beyond the end of a shorter basis hair they are drawn
/// as there. (Hernandez and Rudomin 2004, clumpiness.) What is left of their distance lies flat, is twisted, and grows
/// again near the tip, as the locks' shape says. Neither allocates nor throws; the same bytes with every
/// instruction set.
void clumpLanes(ClumpTask& task);

} // namespace hairpaint::sim
