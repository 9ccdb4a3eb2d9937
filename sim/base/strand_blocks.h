// The one layout in which the nodes of many strands lie: blocks of lanes, one SIMD lane a strand.
#pragma once

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hairpaint::sim {

inline constexpr int kLanes = 16; ///< Strands in a block.

/// Where things of a strand are: strand i is lane i % kLanes of block i / kLanes.
[[nodiscard]] constexpr std::size_t blockOf(std::size_t strand)
{
    return strand / kLanes;
}
[[nodiscard]] constexpr std::size_t laneOf(std::size_t strand)
{
    return strand % kLanes;
}
/// Blocks that hold so many strands.
[[nodiscard]] constexpr std::size_t blocksFor(std::size_t strands)
{
    return (strands + kLanes - 1) / kLanes;
}
/// Index into an array shaped [blocks][rows][kLanes].
[[nodiscard]] constexpr std::size_t rowIndex(std::size_t strand, std::size_t row, std::size_t rows)
{
    return (blockOf(strand) * rows + row) * kLanes + laneOf(strand);
}

/// Sets of strands, one bit a lane: [blocks].
[[nodiscard]] inline bool hasLane(std::span<const std::uint32_t> lanes, std::size_t strand)
{
    return ((lanes[blockOf(strand)] >> laneOf(strand)) & 1U) != 0;
}
inline void insertLane(std::span<std::uint32_t> lanes, std::size_t strand)
{
    lanes[blockOf(strand)] |= 1U << laneOf(strand);
}

/// An array shaped [blocks][nodes][3][kLanes]. Holds no data: the arrays are floats of whoever owns them.
class StrandBlocks
{
public:
    static constexpr std::size_t kAxisStride = kLanes;     ///< From x to y and from y to z of a node.
    static constexpr std::size_t kNodeStride = 3 * kLanes; ///< From a node to the strand's next.

    constexpr explicit StrandBlocks(int nodes) : m_nodes(static_cast<std::size_t>(nodes)) {}

    [[nodiscard]] constexpr std::size_t blockFloats() const { return m_nodes * kNodeStride; }
    [[nodiscard]] constexpr std::size_t floatsFor(std::size_t blocks) const { return blocks * blockFloats(); }
    /// Index of a node's x.
    [[nodiscard]] constexpr std::size_t index(std::size_t strand, std::size_t node) const
    {
        return (blockOf(strand) * m_nodes + node) * kNodeStride + laneOf(strand);
    }

    [[nodiscard]] static glm::vec3 load(const float* x) { return {x[0], x[kAxisStride], x[2 * kAxisStride]}; }
    static void store(float* x, glm::vec3 value)
    {
        x[0] = value.x;
        x[kAxisStride] = value.y;
        x[2 * kAxisStride] = value.z;
    }
    [[nodiscard]] glm::vec3 node(std::span<const float> array, std::size_t strand, std::size_t node) const
    {
        return load(array.data() + index(strand, node));
    }
    void setNode(std::span<float> array, std::size_t strand, std::size_t node, glm::vec3 value) const
    {
        store(array.data() + index(strand, node), value);
    }
    /// The strand's first nodes, as many as the span has room for.
    void read(std::span<const float> array, std::size_t strand, std::span<glm::vec3> nodes) const
    {
        const float* x = array.data() + index(strand, 0);
        for (glm::vec3& node : nodes) {
            node = load(x);
            x += kNodeStride;
        }
    }
    void write(std::span<float> array, std::size_t strand, std::span<const glm::vec3> nodes) const
    {
        float* x = array.data() + index(strand, 0);
        for (const glm::vec3& node : nodes) {
            store(x, node);
            x += kNodeStride;
        }
    }

private:
    std::size_t m_nodes;
};

} // namespace hairpaint::sim
