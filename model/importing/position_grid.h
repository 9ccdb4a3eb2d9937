// Finds positions near a position.
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace hairpaint::model {

/// Positions sorted into cubes. Keeps no reference to them: every call is given those that it was made of. Immutable;
/// any thread.
class PositionGrid
{
public:
    PositionGrid(std::span<const glm::vec3> positions, float cellM);

    /// Calls `use(index)` for the positions in the cubes that a ball touches, in an order that is always the same,
    /// until it returns false.
    template<typename Use>
    void near(const glm::vec3& middle, float radiusM, const Use& use) const
    {
        const glm::ivec3 first = cellOf(middle - radiusM);
        const glm::ivec3 last = cellOf(middle + radiusM);
        for (int z = first.z; z <= last.z; ++z)
            for (int y = first.y; y <= last.y; ++y) {
                const std::size_t row = indexOf({first.x, y, z});
                const std::size_t rowEnd = row + static_cast<std::size_t>(last.x - first.x) + 1;
                for (std::uint32_t i = m_starts[row]; i < m_starts[rowEnd]; ++i)
                    if (!use(m_indices[i]))
                        return;
            }
    }

    /// All of them, cube by cube.
    [[nodiscard]] std::span<const std::uint32_t> order() const { return m_indices; }

private:
    [[nodiscard]] glm::ivec3 cellOf(const glm::vec3& position) const;
    [[nodiscard]] std::size_t indexOf(const glm::ivec3& cell) const;

    float m_cellM;
    glm::vec3 m_least{0.0F};
    glm::ivec3 m_size{1};
    std::vector<std::uint32_t> m_starts; ///< [cells + 1], into m_indices; cells [z][y][x].
    std::vector<std::uint32_t> m_indices;
};

} // namespace hairpaint::model
