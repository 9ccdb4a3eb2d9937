// Bounding balls into the cells of a grid, and who is near whom by it.
#include "sim/solver/braid_pairs.h"

#include "sim/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::sim {

namespace {

constexpr std::size_t kMostBraidCells = 8192;
constexpr std::size_t kListsAtOnce = 8;
constexpr float kFurthestBraidM = 4.0F; ///< From the head's origin; no hair is longer.

} // namespace

void BraidPairs::setBraids(std::span<const float> girthsM, std::span<const float> segmentsM, int nodes)
{
    m_nodes = static_cast<std::size_t>(nodes);
    m_girthsM.assign(girthsM.begin(), girthsM.end());
    const std::size_t segments = girthsM.size() * (m_nodes - 1);
    m_mostOfBraid = blocksFor((m_nodes - 1) * kMostPairs) * kLanes;
    m_listedHd.resize(girthsM.size() * m_nodes);
    m_balls.resize(segments);
    m_sorted.resize(segments);
    m_cellOfBall.resize(segments);
    m_firstOfCell.resize(kMostBraidCells + 1);
    m_first.assign(girthsM.size() * m_mostOfBraid, 0);
    m_second.assign(girthsM.size() * m_mostOfBraid, 0);
    m_counts.assign(girthsM.size(), 0);
    m_isListed = false;
    m_reachM = kNearM + kSlackM;
    for (std::size_t braid = 0; braid < girthsM.size(); ++braid)
        m_reachM = std::max(m_reachM, 2.0F * girthsM[braid] + segmentsM[braid] + kNearM + kSlackM);
}

bool BraidPairs::isRight(std::span<const glm::vec3> nodesHd) const
{
    // Each of two may have gone half of it.
    constexpr float kFurthest2 = 0.25F * kSlackM * kSlackM;
    for (std::size_t i = 0; i < nodesHd.size(); ++i) {
        const glm::vec3 gone = nodesHd[i] - m_listedHd[i];
        if (!(glm::dot(gone, gone) < kFurthest2))
            return false;
    }
    return true;
}

glm::ivec3 BraidPairs::cellOf(glm::vec3 pHd) const
{
    glm::ivec3 cell{0};
    for (int axis = 0; axis < 3; ++axis) {
        const float at = (pHd[axis] - m_originHd[axis]) / m_cellM;
        // What is not a number is in the first cell.
        cell[axis] = at > 0.0F ? std::min(static_cast<int>(std::min(at, 1e6F)), m_cells[axis] - 1) : 0;
    }
    return cell;
}

std::size_t BraidPairs::indexOf(glm::ivec3 cell) const
{
    const int index = (cell.z * m_cells.y + cell.y) * m_cells.x + cell.x;
    return static_cast<std::size_t>(index);
}

void BraidPairs::sortIntoCells(std::span<const glm::vec3> nodesHd)
{
    const std::size_t segmentsABraid = m_nodes - 1;
    glm::vec3 least(kFurthestBraidM);
    glm::vec3 most(-kFurthestBraidM);
    for (std::size_t i = 0; i < m_balls.size(); ++i) {
        const std::size_t braid = i / segmentsABraid;
        const glm::vec3 a = nodesHd[braid * m_nodes + i % segmentsABraid];
        const glm::vec3 b = nodesHd[braid * m_nodes + i % segmentsABraid + 1];
        const glm::vec3 edge = b - a;
        m_balls[i] = {.centreHd = (a + b) * 0.5F,
                      .radiusM = 0.5F * std::sqrt(glm::dot(edge, edge)) + m_girthsM[braid],
                      .segment = static_cast<std::int32_t>(braid * m_nodes + i % segmentsABraid),
                      .braid = static_cast<std::int32_t>(braid)};
        least = glm::min(least, m_balls[i].centreHd);
        most = glm::max(most, m_balls[i].centreHd);
    }
    m_originHd = glm::max(least, glm::vec3(-kFurthestBraidM));
    const glm::vec3 size = glm::max(glm::min(most, glm::vec3(kFurthestBraidM)) - m_originHd, glm::vec3(0.0F));
    for (m_cellM = m_reachM;; m_cellM *= 1.25F) {
        m_cells = glm::ivec3(size / m_cellM) + 1;
        if (static_cast<std::size_t>(m_cells.x) * static_cast<std::size_t>(m_cells.y) *
                static_cast<std::size_t>(m_cells.z) <=
            kMostBraidCells)
            break;
    }
    std::ranges::fill(m_firstOfCell, 0U);
    for (std::size_t i = 0; i < m_balls.size(); ++i) {
        m_cellOfBall[i] = static_cast<std::uint32_t>(indexOf(cellOf(m_balls[i].centreHd)));
        ++m_firstOfCell[m_cellOfBall[i] + 1];
    }
    for (std::size_t cell = 1; cell < m_firstOfCell.size(); ++cell)
        m_firstOfCell[cell] += m_firstOfCell[cell - 1];
    // From the last on, so that each cell's begin comes out of its end.
    for (std::size_t i = m_balls.size(); i-- > 0;)
        m_sorted[--m_firstOfCell[m_cellOfBall[i] + 1]] = m_balls[i];
    // Now [cell + 1] is where the cell begins: one to the left.
    std::shift_left(m_firstOfCell.begin(), m_firstOfCell.end(), 1);
    m_firstOfCell.back() = static_cast<std::uint32_t>(m_balls.size());
}

void BraidPairs::findPairs(const BraidNodes& nodes, std::size_t braid)
{
    const std::size_t segmentsABraid = m_nodes - 1;
    Candidates candidates;
    m_counts[braid] = 0;
    for (std::size_t i = braid * segmentsABraid; i < (braid + 1) * segmentsABraid; ++i) {
        const Ball& ball = m_balls[i];
        const glm::ivec3 cell = cellOf(ball.centreHd);
        const glm::ivec3 low = glm::max(cell - 1, 0);
        const glm::ivec3 high = glm::min(cell + 1, m_cells - 1);
        for (int z = low.z; z <= high.z; ++z)
            for (int y = low.y; y <= high.y; ++y) {
                const std::size_t end = m_firstOfCell[indexOf({high.x, y, z}) + 1];
                for (std::size_t other = m_firstOfCell[indexOf({low.x, y, z})]; other < end; ++other) {
                    const Ball& beside = m_sorted[other];
                    const float reach = ball.radiusM + beside.radiusM + (kNearM + kSlackM);
                    const glm::vec3 between = ball.centreHd - beside.centreHd;
                    if (beside.braid <= ball.braid || !(glm::dot(between, between) < reach * reach))
                        continue;
                    candidates.first[candidates.count] = ball.segment;
                    candidates.second[candidates.count++] = beside.segment;
                    if (candidates.count == Candidates::kMost)
                        addNear(nodes, braid, candidates);
                }
            }
    }
    addNear(nodes, braid, candidates);
}

/// Those that are near to each other indeed.
void BraidPairs::addNear(const BraidNodes& nodes, std::size_t braid, Candidates& candidates)
{
    SegmentsApart apart;
    findNearestPoints(nodes, {candidates.first.data(), candidates.second.data()}, apart, candidates.count);
    std::uint32_t count = m_counts[braid];
    for (std::size_t i = 0; i < candidates.count && count < m_mostOfBraid; ++i) {
        const float reach = apart.clear[i] + (kNearM + kSlackM);
        if (!(apart.distance2[i] < reach * reach))
            continue;
        m_first[braid * m_mostOfBraid + count] = candidates.first[i];
        m_second[braid * m_mostOfBraid + count++] = candidates.second[i];
    }
    m_counts[braid] = count;
    candidates.count = 0;
}

void BraidPairs::update(std::span<const glm::vec3> nodesHd, const BraidNodes& nodes)
{
    ++m_updates;
    if (m_isListed && (m_updates < kUpdatesAList || isRight(nodesHd)))
        return;
    sortIntoCells(nodesHd);
    parallelFor(m_girthsM.size(), kListsAtOnce, [&](std::size_t begin, std::size_t end) {
        for (std::size_t braid = begin; braid < end; ++braid)
            findPairs(nodes, braid);
    });
    std::ranges::copy(nodesHd, m_listedHd.begin());
    m_isListed = true;
    m_updates = 0;
    ++m_listsMade;
}

} // namespace hairpaint::sim
