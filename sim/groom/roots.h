// Candidate roots: drawn once per head and group, so that painting never moves a hair.
#pragma once

#include "sim/base/strand_blocks.h"
#include "sim/skin/skin_frame.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace hairpaint::sim {

inline constexpr int kRootsAlgorithm = 1; ///< Written to project files as `roots.algorithm`.
inline constexpr int kBlocksPerChunk = 64;
inline constexpr int kChunkSlots = kLanes * kBlocksPerChunk;

/// Candidate i (its *rank*) of N has threshold (i + 1/2)/N and is a hair where the density at its uv is above that.
/// Every prefix of the ranks is an even cover by area. Candidates are stored by *slot*: neighbours on the skin share
/// chunks of kChunkSlots, and within a chunk ranks rise; `rank` and `slot` translate. Basis hairs are the candidates
/// with rank < basisCount. Immutable. (Hernandez and Rudomin 2004, section on roots: uniform barycentrics; algorithm 3:
/// basis hairs.)
struct RootSet
{
    static constexpr int kNeighbours = 3;

    std::shared_ptr<const Skin> skin;
    std::uint64_t seed = 1;
    std::vector<std::uint32_t> rankOfSlot;
    std::vector<std::uint32_t> slotOfRank;
    std::vector<std::uint32_t> face; ///< By slot, as are the following.
    std::vector<glm::vec2> uv;
    std::vector<glm::vec3> positionHd;
    std::vector<glm::vec3> normalHd;    ///< Unit.
    std::vector<glm::vec3> tangentHd;   ///< Unit, see SurfacePoint.
    std::vector<std::uint8_t> mirrored; ///< 1 where uv is mirrored on the skin, so that SkinFrame's y is turned round.
    /// The nearest basis hairs of each slot, nearest first, as indices into `basisSlot`; a basis hair's own first.
    std::vector<std::array<std::uint32_t, kNeighbours>> neighbours;
    std::vector<std::array<float, kNeighbours>> weights; ///< Sum to 1; a basis hair's own weighs 1.
    /// Slots of the basis hairs: neighbours in space are neighbours here.
    std::vector<std::uint32_t> basisSlot;

    [[nodiscard]] std::size_t count() const { return rankOfSlot.size(); }
    [[nodiscard]] SkinFrame frame(std::uint32_t slot) const
    {
        const glm::vec3 side = glm::cross(normalHd[slot], tangentHd[slot]);
        return {.x = tangentHd[slot], .y = mirrored[slot] != 0 ? -side : side, .normal = normalHd[slot]};
    }
    /// The point of the skin where a hair has its root.
    [[nodiscard]] SurfacePoint surfacePoint(std::uint32_t slot) const;
    [[nodiscard]] float threshold(std::uint32_t slot) const
    {
        return (static_cast<float>(rankOfSlot[slot]) + 0.5F) / static_cast<float>(count());
    }
};

/// N = count candidates, the first `basisCount` ranks of them (at most N) basis hairs. Any thread; uses `parallelFor`.
/// The same arguments give the same bytes on every machine. A larger count only appends ranks.
[[nodiscard]] std::shared_ptr<const RootSet> buildRoots(std::shared_ptr<const Skin> skin, std::size_t count,
                                                        std::size_t basisCount, std::uint64_t seed);

} // namespace hairpaint::sim
