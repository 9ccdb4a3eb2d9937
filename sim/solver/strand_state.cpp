// Strands in blocks of lanes.
#include "sim/solver/strand_state.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hairpaint::sim {

void StrandState::resize(int nodeCount, std::size_t blockCount, int colliders)
{
    nodes = nodeCount;
    blocks = blockCount;
    const std::size_t floats = shape().floatsFor(blockCount);
    for (AlignedFloats& side : positions)
        side.assign(floats, 0.0F);
    previous.assign(floats, 0.0F);
    laneRows = kScale + colliders;
    lanes.assign(blockCount * static_cast<std::size_t>(laneRows) * kLanes, 0.0F);
    awake.assign(blockCount, 0);
    for (std::size_t strand = 0; strand < blockCount * kLanes; ++strand)
        field(strand, kStill) = kUnwanted;
}

void StrandState::setColliders(int colliders)
{
    if (laneRows == kScale + colliders)
        return;
    const auto rowsBefore = static_cast<std::size_t>(laneRows);
    const AlignedFloats lanesBefore = std::exchange(lanes, {});
    laneRows = kScale + colliders;
    const auto rows = static_cast<std::size_t>(laneRows);
    lanes.assign(blocks * rows * kLanes, 0.0F);
    for (std::size_t block = 0; block < blocks; ++block)
        std::copy_n(lanesBefore.data() + block * rowsBefore * kLanes, std::size_t{kScale} * kLanes,
                    lanes.data() + block * rows * kLanes);
}

SolverBlocks StrandState::view(const float* rest)
{
    return {rest,         {positions[0].data(), positions[1].data()}, previous.data(),
            lanes.data(), static_cast<std::size_t>(laneRows),         awake.data()};
}

void StrandState::copyStrand(const StrandState& from, std::size_t fromStrand, std::size_t toStrand)
{
    for (std::size_t node = 0; node < static_cast<std::size_t>(nodes); ++node) {
        shape().setNode(now(), toStrand, node, shape().node(from.now(), fromStrand, node));
        shape().setNode(before(), toStrand, node, shape().node(from.before(), fromStrand, node));
        shape().setNode(previous, toStrand, node, shape().node(from.previous, fromStrand, node));
    }
    for (int row = 0; row < std::min(laneRows, from.laneRows); ++row)
        field(toStrand, row) = from.field(fromStrand, row);
}

void StrandState::setStrand(std::size_t strand, std::span<const glm::vec3> nodesHd)
{
    for (AlignedFloats* array : {&positions[0], &positions[1], &previous})
        shape().write(*array, strand, nodesHd);
    field(strand, kStretch) = field(strand, kStretchSpeed) = 0.0F;
    field(strand, kLoad) = kUnwanted;
    wakeStrand(strand);
}

void StrandState::stopStrand(std::size_t strand)
{
    for (std::size_t node = 0; node < static_cast<std::size_t>(nodes); ++node) {
        const glm::vec3 nowHd = shape().node(now(), strand, node);
        shape().setNode(before(), strand, node, nowHd);
        shape().setNode(previous, strand, node, nowHd);
    }
}

void StrandState::reshapeStrand(std::size_t strand, const Reshaping& to)
{
    const float kept = to.factor * (1.0F - to.turned);
    if (to.isRootMoved) {
        for (AlignedFloats* array : {&previous, &before(), &now()})
            shape().setNode(*array, strand, 0, to.afterHd[0]);
    }
    glm::vec3 parent = shape().node(now(), strand, 0);
    for (std::size_t node = 1; node < static_cast<std::size_t>(nodes); ++node) {
        const glm::vec3 was = shape().node(now(), strand, node);
        glm::vec3 wanted = to.afterHd[node] + (was - to.beforeHd[node]) * to.factor;
        if (to.turned > 0.0F)
            wanted += (to.hangingHd[node] - wanted) * to.turned;
        const glm::vec3 edge = wanted - parent;
        const float square = glm::dot(edge, edge);
        const glm::vec3 straight = to.afterHd[node] - to.afterHd[node - 1];
        const glm::vec3 positionHd = parent + (square > 1e-12F ? edge * (to.segmentM / std::sqrt(square)) : straight);
        for (AlignedFloats* array : {&previous, &before()})
            shape().setNode(*array, strand, node, positionHd + (shape().node(*array, strand, node) - was) * kept);
        shape().setNode(now(), strand, node, positionHd);
        parent = positionHd;
    }
    wakeStrand(strand);
}

void StrandState::wakeStrand(std::size_t strand)
{
    field(strand, kStill) = 0.0F;
    awake[blockOf(strand)] = 1;
}

} // namespace hairpaint::sim
