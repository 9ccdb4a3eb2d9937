// The point of the skin nearest to a position close to it.
#pragma once

#include "sim/skin/skin_frame.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace hairpaint::sim {

/// Cells of a grid within kReachM of the skin, on both sides, each with the point of the skin nearest to its middle.
/// Immutable; any thread. 50 bytes a cell: some 10 MB for a bust.
class SkinBand
{
public:
    static constexpr float kReachM = 0.014F;

    static constexpr std::int32_t kNone = -1;

    /// Which cell a position is in: (position - origin) * perCell, each axis cut to a whole number, and kNone where
    /// that is out of the grid or the cell is too far from the skin.
    struct Grid
    {
        const std::int32_t* indices = nullptr; ///< [z][y][x] index into cells(), or kNone.
        glm::vec3 originHd{0.0F};
        glm::vec3 size{0.0F}; ///< Cells along each axis.
        float perCell = 0.0F; ///< 1/m
    };

    struct Cell
    {
        glm::vec3 positionHd{0.0F}; ///< Point of the skin nearest to the cell's middle.
        glm::vec2 uv{0.0F};
        SkinFrame frame;
    };

    /// Uses parallelFor; about 50 ms for a bust.
    explicit SkinBand(const Skin& skin);

    [[nodiscard]] Grid grid() const { return {m_index.data(), m_originHd, m_size, m_perCell}; }
    [[nodiscard]] std::span<const Cell> cells() const { return m_cells; }
    [[nodiscard]] std::int32_t cellAt(glm::vec3 positionHd) const; ///< See Grid.
    /// All cells in which a position may be that is no further than `reachM` from one in any of the cells; rising.
    [[nodiscard]] std::vector<std::uint32_t> around(std::span<const std::uint32_t> cells, float reachM) const;

private:
    glm::vec3 m_originHd{0.0F};
    glm::vec3 m_size{0.0F};
    float m_perCell = 0.0F;
    std::size_t m_columns = 0;
    std::size_t m_rows = 0;
    std::vector<std::int32_t> m_index; ///< [z][y][x] index into m_cells, or kNone.
    std::vector<Cell> m_cells;
    std::vector<std::uint32_t> m_gridIndex; ///< [cells] index of the cell in m_index.
};

/// The skin's band, made at the first call and kept as long as the skin lives. Any thread.
[[nodiscard]] std::shared_ptr<const SkinBand> bandOf(const std::shared_ptr<const Skin>& skin);

} // namespace hairpaint::sim
