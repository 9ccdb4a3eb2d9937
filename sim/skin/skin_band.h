// What skin lies below a place close over it.
#pragma once

#include "sim/skin/skin_frame.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hairpaint::sim {

/// Cells of a grid within kReachM of the skin, on both sides, each with the place on the skin nearest to its middle.
/// Immutable; any thread. 50 bytes a cell: some 10 MB for a bust.
class SkinBand
{
public:
    static constexpr float kReachM = 0.014F;

    static constexpr std::uint32_t kNone = 0xFFFFFFFFU;

    struct Cell
    {
        glm::vec3 positionHd{0.0F}; ///< On the skin.
        glm::vec2 uv{0.0F};
        SkinFrame frame;
    };

    /// Uses parallelFor; about 50 ms for a bust.
    explicit SkinBand(const Skin& skin);

    /// Of the cell that a place is in; kNone further away.
    [[nodiscard]] std::uint32_t indexAt(glm::vec3 placeHd) const
    {
        const glm::vec3 cell = (placeHd - m_originHd) * m_perCell;
        // False for what is not a number.
        if (!(cell.x >= 0.0F && cell.y >= 0.0F && cell.z >= 0.0F && cell.x < m_size.x && cell.y < m_size.y &&
              cell.z < m_size.z))
            return kNone;
        const std::size_t index =
            (static_cast<std::size_t>(cell.z) * m_rows + static_cast<std::size_t>(cell.y)) * m_columns +
            static_cast<std::size_t>(cell.x);
        return m_index[index];
    }

    [[nodiscard]] std::span<const Cell> cells() const { return m_cells; }

private:
    glm::vec3 m_originHd{0.0F};
    glm::vec3 m_size{0.0F};
    float m_perCell = 0.0F;
    std::size_t m_columns = 0;
    std::size_t m_rows = 0;
    std::vector<std::uint32_t> m_index; ///< [z][y][x]
    std::vector<Cell> m_cells;
};

} // namespace hairpaint::sim
