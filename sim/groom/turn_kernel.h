// Turns hairs around their roots.
#pragma once

#include "sim/base/strand_blocks.h"
#include "sim/groom/variation.h"
#include "sim/skin/skin_frame.h"

#include <array>
#include <cstddef>

namespace hairpaint::sim {

/// kLanes laid hairs and how each is turned. Nodes are [nodes][3][kLanes]. Hd, m.
struct TurnTask
{
    using Row = std::array<float, kLanes>;
    /// By an angle around a unit axis through the root.
    struct Turn
    {
        std::array<Row, 3> axis{};
        Row sine{};
        Row cosine{};
    };

    int nodes = 0;
    float* nodesHd = nullptr;
    Turn lean;   ///< First,
    Turn across; ///< then around the skin's normal.
    Row turns{}; ///< 1 where a hair is turned; another keeps its bytes.

    /// Has a lane turned as its hair's chance wants, a long hair by less, so that its tip stays among others, and one
    /// that keeps to a lock the less the closer it does: `clump` 0..1. `frame`: at its root. Reads `nodesHd`.
    void turnLane(std::size_t lane, const HairVariation& variation, float clump, const SkinFrame& frame, float lengthM);
};

/// Turns the lanes that are to be turned; lengths stay. Neither allocates nor throws; the same bytes with every
/// instruction set.
void turnLanes(const TurnTask& task);

} // namespace hairpaint::sim
