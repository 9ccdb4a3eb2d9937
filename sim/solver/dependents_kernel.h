// Every drawn hair's nodes from the basis hairs around it (Hernandez and Rudomin 2004, algorithm 3).
#pragma once

#include "sim/solver/solver_layout.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace hairpaint::sim {

/// Rows of kLanes floats of a block of dependents.
enum DependentRow : std::uint8_t
{
    kDependentSegment,   ///< Segment length, m; 0 where nothing is drawn.
    kDependentClearance, ///< From the skin, m.
    kDependentClumpX,    ///< From the root to that of the nearest basis hair, by the clump. Hd, m.
    kDependentClumpY,
    kDependentClumpZ,
    kDependentScale ///< A row for each collider: its squared scale.
};
[[nodiscard]] constexpr std::size_t dependentRows(const ColliderSet& colliders)
{
    return std::size_t{kDependentScale} + static_cast<std::size_t>(colliders.count);
}

inline constexpr std::size_t kBasisFloats = 8;
inline constexpr std::size_t kBasisStretch = 7; ///< Index in them of the fraction by which it is longer now.

/// One chunk's worth of dependents. Hd, m, but `out`, which is in the world.
struct DependentsTask
{
    int nodes = 0;
    /// [basis hairs][nodes][kBasisFloats]: the node's displacement from its rest position, nothing, the rest position
    /// from the root and how much longer the basis hair is; displacement and position by its length.
    const float* displacements = nullptr;
    const std::array<std::uint32_t, 3>* neighbours = nullptr; ///< [kChunkSlots], indices of basis hairs.
    const std::array<float, 3>* weights = nullptr;            ///< [kChunkSlots], in any unit.
    const float* rest = nullptr;                              ///< [kBlocksPerChunk][nodes][3][kLanes]
    const float* lanes = nullptr;                             ///< [kBlocksPerChunk][dependentRows(colliders)][kLanes]
    const float* leastDetail = nullptr;                       ///< [kBlocksPerChunk], see StrandChunk.
    float detail = 1.0F;                                      ///< Blocks without a hair below are left as they are,
                                                              ///< unless it is 1.
    const ColliderSet* colliders = nullptr;
    bool beginsInAir = false; ///< See GroupGains.
    RigidMotion world;        ///< From the head's frame.
    NeckTurn neck;
    float* out = nullptr; ///< As `rest`; zeros where nothing is drawn.
};

/// Blocks begin..end of the chunk. A node's displacement is the weighted mean of its basis hairs' at the same node;
/// neighbours that hang to another side than the foremost (across a parting) count less. What a hair's own rest shape
/// has of its own beside theirs is forgotten where they have moved far: two hairs of which one is laid over the ear
/// hang side by side. Then segment lengths are restored from root to tip, outside ellipsoids and skin. Neither
/// allocates nor throws; the same bytes with every instruction set.
void positionDependents(const DependentsTask& task, std::size_t begin, std::size_t end);

} // namespace hairpaint::sim
