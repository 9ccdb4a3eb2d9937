// Which segments of a group's braids are so near to each other that they may come to touch.
#pragma once

#include "sim/base/aligned_floats.h"
#include "sim/base/strand_blocks.h"
#include "sim/solver/braid_kernel.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hairpaint::sim {

/// A list that is made anew when a node has gone further than it allows for (Verlet 1967), but not more often than
/// every kUpdatesAList updates: in a storm braids may pass through each other. It is made from a grid of the segments'
/// bounding balls. A segment is known by the node that it begins in, counted through all braids. Memory is taken in
/// setBraids alone. Loops run through parallelFor, with the same result for any number of threads. Of more pairs than
/// kMostPairs a segment, on average over a braid's, those of its last segments are left out.
class BraidPairs
{
public:
    static constexpr std::size_t kMostPairs = 48;
    static constexpr float kNearM = 0.002F;  ///< Gap up to which pairs are wanted,
    static constexpr float kSlackM = 0.005F; ///< and how much further the list reaches.
    static constexpr int kUpdatesAList = 4;

    /// `girthsM`, `segmentsM`: [braids]; no pairs yet.
    void setBraids(std::span<const float> girthsM, std::span<const float> segmentsM, int nodes);
    /// `nodesHd`: [braids][nodes], the same as `nodes`. Makes the list anew if it is no longer right.
    void update(std::span<const glm::vec3> nodesHd, const BraidNodes& nodes);
    /// The pairs of a segment of that braid and one of a braid of a higher number. Both arrays start on a cache line
    /// and have room for a whole number of kLanes.
    [[nodiscard]] std::span<const std::int32_t> first(std::size_t braid) const
    {
        return std::span(m_first).subspan(braid * m_mostOfBraid, m_counts[braid]);
    }
    [[nodiscard]] std::span<const std::int32_t> second(std::size_t braid) const
    {
        return std::span(m_second).subspan(braid * m_mostOfBraid, m_counts[braid]);
    }
    [[nodiscard]] std::uint64_t listsMade() const { return m_listsMade; }

private:
    /// A segment's bounding ball, with its braid's girth.
    struct Ball
    {
        glm::vec3 centreHd{0.0F};
        float radiusM = 0.0F;
        std::int32_t segment = 0;
        std::int32_t braid = 0;
    };

    /// Segments whose balls meet, on the stack of a loop.
    struct Candidates
    {
        static constexpr std::size_t kMost = SegmentsApart::kMost;
        alignas(64) std::array<std::int32_t, kMost> first{};
        alignas(64) std::array<std::int32_t, kMost> second{};
        std::size_t count = 0;
    };

    [[nodiscard]] bool isRight(std::span<const glm::vec3> nodesHd) const;
    void sortIntoCells(std::span<const glm::vec3> nodesHd);
    [[nodiscard]] glm::ivec3 cellOf(glm::vec3 pHd) const;
    [[nodiscard]] std::size_t indexOf(glm::ivec3 cell) const;
    void findPairs(const BraidNodes& nodes, std::size_t braid);
    void addNear(const BraidNodes& nodes, std::size_t braid, Candidates& candidates);

    std::size_t m_nodes = 0;
    std::size_t m_mostOfBraid = 0;
    float m_reachM = 0.0F; ///< Greatest distance of the centres of two segments that are a pair.
    std::vector<float> m_girthsM;
    std::vector<glm::vec3> m_listedHd; ///< Where the nodes were when the list was made; empty: never.
    std::vector<Ball> m_balls;         ///< By segment,
    std::vector<Ball> m_sorted;        ///< and by cell.
    std::vector<std::uint32_t> m_cellOfBall;
    std::vector<std::uint32_t> m_firstOfCell; ///< [cells + 1]
    glm::vec3 m_originHd{0.0F};
    float m_cellM = 1.0F;
    glm::ivec3 m_cells{1};
    using Indices = std::vector<std::int32_t, CacheLineAllocator<std::int32_t>>;
    Indices m_first, m_second;           ///< [braids][m_mostOfBraid]
    std::vector<std::uint32_t> m_counts; ///< [braids]
    bool m_isListed = false;
    int m_updates = 0; ///< Since the list was made.
    std::uint64_t m_listsMade = 0;
};

} // namespace hairpaint::sim
