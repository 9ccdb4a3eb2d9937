// Positions counted by cube, then sorted into them.
#include "model/importing/position_grid.h"

#include <algorithm>
#include <limits>

namespace hairpaint::model {

namespace {

constexpr int kMostCubesASide = 256;

} // namespace

PositionGrid::PositionGrid(std::span<const glm::vec3> positions, float cellM) : m_cellM(cellM)
{
    glm::vec3 greatest(0.0F);
    if (!positions.empty()) {
        m_least = greatest = positions.front();
        for (const glm::vec3& position : positions) {
            m_least = glm::min(m_least, position);
            greatest = glm::max(greatest, position);
        }
    }
    const glm::vec3 size = greatest - m_least;
    m_cellM = std::max(cellM, std::max({size.x, size.y, size.z, 1e-6F}) / static_cast<float>(kMostCubesASide - 1));
    m_size = glm::ivec3(size / m_cellM) + 1;
    const auto cells =
        static_cast<std::size_t>(m_size.x) * static_cast<std::size_t>(m_size.y) * static_cast<std::size_t>(m_size.z);
    m_starts.resize(cells + 1);
    for (const glm::vec3& position : positions)
        ++m_starts[indexOf(cellOf(position)) + 1];
    for (std::size_t cell = 0; cell < cells; ++cell)
        m_starts[cell + 1] += m_starts[cell];
    m_indices.resize(positions.size());
    std::vector<std::uint32_t> next(m_starts.begin(), m_starts.end() - 1);
    for (std::size_t i = 0; i < positions.size(); ++i)
        m_indices[next[indexOf(cellOf(positions[i]))]++] = static_cast<std::uint32_t>(i);
}

glm::ivec3 PositionGrid::cellOf(const glm::vec3& position) const
{
    const glm::vec3 at = glm::clamp((position - m_least) / m_cellM, glm::vec3(0.0F), glm::vec3(m_size - 1));
    return {at};
}

std::size_t PositionGrid::indexOf(const glm::ivec3& cell) const
{
    return (static_cast<std::size_t>(cell.z) * static_cast<std::size_t>(m_size.y) + static_cast<std::size_t>(cell.y)) *
               static_cast<std::size_t>(m_size.x) +
           static_cast<std::size_t>(cell.x);
}

} // namespace hairpaint::model
