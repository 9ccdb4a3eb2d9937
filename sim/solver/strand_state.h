// The moving state of a group's basis hairs, and what can be done to one strand of it.
#pragma once

#include "sim/base/aligned_floats.h"
#include "sim/solver/solver_layout.h"

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace hairpaint::sim {

/// See SolverBlocks for the shapes. `present` tells which of `positions` is the present; the other is a step older.
struct StrandState
{
    int nodes = 0;
    std::size_t blocks = 0;
    int present = 0;
    std::array<AlignedFloats, 2> positions;
    AlignedFloats previous;
    AlignedFloats lanes;
    int laneRows = kScale; ///< kScale and the colliders.
    std::vector<std::uint8_t> awake;

    /// Zeros, and no strand wanted.
    void resize(int nodeCount, std::size_t blockCount, int colliders);
    /// Room for the scales of so many; where their number changes all are zero.
    void setColliders(int colliders);
    [[nodiscard]] SolverBlocks view(const float* rest);
    [[nodiscard]] StrandBlocks shape() const { return StrandBlocks(nodes); }
    /// The nodes now, and a step ago.
    [[nodiscard]] AlignedFloats& now() { return positions[static_cast<std::size_t>(present)]; }
    [[nodiscard]] const AlignedFloats& now() const { return positions[static_cast<std::size_t>(present)]; }
    [[nodiscard]] AlignedFloats& before() { return positions[static_cast<std::size_t>(1 - present)]; }
    [[nodiscard]] const AlignedFloats& before() const { return positions[static_cast<std::size_t>(1 - present)]; }
    [[nodiscard]] float& field(std::size_t strand, int row) { return lanes[laneIndex(strand, row)]; }
    [[nodiscard]] float field(std::size_t strand, int row) const { return lanes[laneIndex(strand, row)]; }

    void copyStrand(const StrandState& from, std::size_t fromStrand, std::size_t toStrand);
    /// Both steps at `nodesHd`, without speed, awake.
    void setStrand(std::size_t strand, std::span<const glm::vec3> nodesHd);
    /// Without speed where it is.
    void stopStrand(std::size_t strand);
    /// Another rest shape, root first.
    struct Reshaping
    {
        std::span<const glm::vec3> beforeHd;
        std::span<const glm::vec3> afterHd;
        std::span<const glm::vec3> hangingHd; ///< How it would hang by it; not read where `turned` is 0.
        float turned = 0.0F;                  ///< 0..1: how far it points elsewhere than the one before.
        float factor = 1.0F;                  ///< Its length by that before.
        float segmentM = 0.0F;
        bool isRootMoved = false; ///< Else that stays as it is.
    };
    /// As far from the rest shape as it was from that before, times `factor`, with as much of its speed; as far as it
    /// has `turned`, hanging still.
    void reshapeStrand(std::size_t strand, const Reshaping& to);
    void wakeStrand(std::size_t strand);

private:
    [[nodiscard]] std::size_t laneIndex(std::size_t strand, int row) const
    {
        return rowIndex(strand, static_cast<std::size_t>(row), static_cast<std::size_t>(laneRows));
    }
};

} // namespace hairpaint::sim
