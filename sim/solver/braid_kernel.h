// Where segments of braids are nearest to each other, as many pairs at a time as there are lanes.
#pragma once

#include "sim/base/strand_blocks.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace hairpaint::sim {

/// Nodes of braids, [braids][nodes] each. Hd, m.
struct BraidNodes
{
    const float* x = nullptr;
    const float* y = nullptr;
    const float* z = nullptr;
    const float* radius = nullptr; ///< Of the braid there; in between it changes evenly.
};

/// Pairs of segments, each by the node that it begins in. Both arrays have room for a whole number of kLanes and start
/// on a cache line; behind the pairs may be any others.
struct SegmentPairs
{
    const std::int32_t* first = nullptr;
    const std::int32_t* second = nullptr;
};

/// What is found of so many pairs at once.
struct SegmentsApart
{
    static constexpr std::size_t kMost = 16 * std::size_t{kLanes};
    alignas(64) std::array<float, kMost> alongFirst;  ///< 0..1: from the node to the next,
    alignas(64) std::array<float, kMost> alongSecond; ///< where they are nearest.
    alignas(64) std::array<float, kMost> distance2;   ///< Squared distance of these points, m2,
    alignas(64) std::array<float, kMost> clear;       ///< and at which distance they only touch, m.
};

/// Of segments that are nearly parallel, the points in the middle of where they are beside each other: else a trembling
/// of either would throw them from end to end. Neither allocates nor throws; the same bytes with every instruction set.
void findNearestPoints(const BraidNodes& nodes, const SegmentPairs& pairs, SegmentsApart& apart, std::size_t count);

} // namespace hairpaint::sim
