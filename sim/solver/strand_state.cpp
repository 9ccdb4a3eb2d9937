// Strands in blocks of lanes.
#include "sim/solver/strand_state.h"

namespace hairpaint::sim {

void StrandState::resize(int nodeCount, std::size_t blockCount)
{
    nodes = nodeCount;
    blocks = blockCount;
    const std::size_t floats = blockCount * static_cast<std::size_t>(nodeCount) * 3 * kLanes;
    for (AlignedFloats& side : positions)
        side.assign(floats, 0.0F);
    previous.assign(floats, 0.0F);
    lanes.assign(blockCount * kLaneStride, 0.0F);
    awake.assign(blockCount, 0);
    for (std::size_t strand = 0; strand < blockCount * kLanes; ++strand)
        field(strand, kStill) = kUnwanted;
}

SolverBlocks StrandState::view(const float* rest)
{
    return {rest, {positions[0].data(), positions[1].data()}, previous.data(), lanes.data(), awake.data()};
}

std::size_t StrandState::nodeAt(std::size_t strand, int node) const
{
    const std::size_t block = strand / kLanes;
    return (block * static_cast<std::size_t>(nodes) + static_cast<std::size_t>(node)) * 3 * kLanes + strand % kLanes;
}

float& StrandState::field(std::size_t strand, int row)
{
    return lanes[strand / kLanes * kLaneStride + static_cast<std::size_t>(row) * kLanes + strand % kLanes];
}

void StrandState::copyStrand(const StrandState& from, std::size_t fromStrand, std::size_t toStrand)
{
    for (int node = 0; node < nodes; ++node) {
        const std::size_t source = from.nodeAt(fromStrand, node);
        const std::size_t target = nodeAt(toStrand, node);
        for (std::size_t axis = 0; axis < 3 * kLanes; axis += kLanes) {
            for (int step = 0; step < 2; ++step) {
                const auto theirs = static_cast<std::size_t>(from.present ^ step);
                const auto ours = static_cast<std::size_t>(present ^ step);
                positions[ours][target + axis] = from.positions[theirs][source + axis];
            }
            previous[target + axis] = from.previous[source + axis];
        }
    }
    for (int row = 0; row < kLaneFields; ++row)
        field(toStrand, row) = from.lanes[fromStrand / kLanes * kLaneStride + static_cast<std::size_t>(row) * kLanes +
                                          fromStrand % kLanes];
}

void StrandState::placeStrand(std::size_t strand, std::span<const glm::vec3> nodesHd)
{
    for (int node = 0; node < nodes; ++node) {
        const std::size_t at = nodeAt(strand, node);
        for (int axis = 0; axis < 3; ++axis) {
            const std::size_t index = at + static_cast<std::size_t>(axis) * kLanes;
            const float value = nodesHd[static_cast<std::size_t>(node)][axis];
            positions[0][index] = positions[1][index] = previous[index] = value;
        }
    }
    wakeStrand(strand);
}

void StrandState::stopStrand(std::size_t strand)
{
    const AlignedFloats& now = positions[static_cast<std::size_t>(present)];
    AlignedFloats& older = positions[static_cast<std::size_t>(1 - present)];
    for (int node = 0; node < nodes; ++node) {
        for (std::size_t axis = 0; axis < 3 * kLanes; axis += kLanes) {
            const std::size_t index = nodeAt(strand, node) + axis;
            older[index] = previous[index] = now[index];
        }
    }
}

void StrandState::rescaleStrand(std::size_t strand, float factor)
{
    const std::size_t rootAt = nodeAt(strand, 0);
    for (std::size_t axis = 0; axis < 3 * kLanes; axis += kLanes) {
        const float root = positions[static_cast<std::size_t>(present)][rootAt + axis];
        for (int node = 1; node < nodes; ++node) {
            const std::size_t index = nodeAt(strand, node) + axis;
            for (AlignedFloats* side : {&positions[0], &positions[1], &previous})
                (*side)[index] = root + ((*side)[index] - root) * factor;
        }
    }
    wakeStrand(strand);
}

void StrandState::wakeStrand(std::size_t strand)
{
    field(strand, kStill) = 0.0F;
    awake[strand / kLanes] = 1;
}

void readStrand(const float* positions, int nodes, std::size_t strand, std::span<glm::vec3> nodesHd)
{
    const float* at = positions + strand / kLanes * static_cast<std::size_t>(nodes) * 3 * kLanes + strand % kLanes;
    for (int node = 0; node < nodes; ++node, at += 3 * kLanes)
        nodesHd[static_cast<std::size_t>(node)] = {at[0], at[kLanes], at[2 * kLanes]};
}

} // namespace hairpaint::sim
