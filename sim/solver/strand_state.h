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
    std::vector<std::uint8_t> awake;

    /// Zeros, and no strand wanted.
    void resize(int nodeCount, std::size_t blockCount);
    [[nodiscard]] SolverBlocks view(const float* rest);
    [[nodiscard]] std::size_t nodeAt(std::size_t strand, int node) const;
    [[nodiscard]] float* laneRows(std::size_t block) { return lanes.data() + block * kLaneStride; }
    [[nodiscard]] float& field(std::size_t strand, int row);

    void copyStrand(const StrandState& from, std::size_t fromStrand, std::size_t toStrand);
    /// Both steps at `nodesHd`, without speed, awake.
    void placeStrand(std::size_t strand, std::span<const glm::vec3> nodesHd);
    /// Without speed where it is.
    void stopStrand(std::size_t strand);
    /// Larger or smaller by `factor` about its root, speed as well.
    void rescaleStrand(std::size_t strand, float factor);
    void wakeStrand(std::size_t strand);
};

/// A strand's nodes from an array shaped [blocks][nodes][3][kLanes].
void readStrand(const float* positions, int nodes, std::size_t strand, std::span<glm::vec3> nodesHd);

} // namespace hairpaint::sim
