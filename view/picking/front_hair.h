// How far away the foremost hair is, in small cells of the picture around a brush.
#pragma once

#include "view/picking/hair_boxes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace hairpaint::view {

/// A cell is closed where two of the hairs that are added lie before each other: one that strays hides nothing. The
/// order in which points come makes no difference.
class FrontHair
{
public:
    FrontHair(const PictureBox& box, float cellPx)
        : m_box(box), m_cellPx(cellPx), m_perPx(1.0F / cellPx), m_across(cells(box.right - box.left)),
          m_cells(m_across * cells(box.bottom - box.top))
    {
        for (Cell& cell : m_cells)
            cell.fill(kOpen);
    }

    /// The points of a segment, px and depth, a cell apart.
    void add(glm::vec3 from, glm::vec3 to)
    {
        const glm::vec3 segment = to - from;
        const float longest = std::max(std::abs(segment.x), std::abs(segment.y));
        const auto steps = static_cast<int>(std::min(longest * m_perPx, 64.0F)) + 1;
        const float step = 1.0F / static_cast<float>(steps);
        std::size_t last = kNoCell;
        for (int i = 0; i < steps; ++i) {
            const glm::vec3 point = from + segment * ((static_cast<float>(i) + 0.5F) * step);
            const std::size_t cell = cellOf(point);
            if (cell != last && cell != kNoCell && point.z > 0.0F)
                insert(m_cells[cell], point.z);
            last = cell;
        }
    }
    void add(const FrontHair& other)
    {
        for (std::size_t i = 0; i < m_cells.size(); ++i)
            for (const float depth : other.m_cells[i])
                insert(m_cells[i], depth);
    }
    /// Whether hair lies before a point by more than the thickness of what is seen together.
    [[nodiscard]] bool hides(glm::vec3 seen) const
    {
        const std::size_t cell = cellOf(seen);
        return cell != kNoCell && seen.z > m_cells[cell].back() + kSeenM;
    }

    /// Whether it lies before all that a box holds, from that depth on.
    [[nodiscard]] bool hidesAll(const PictureBox& box, float nearestM) const
    {
        const auto index = [this](float px) { return static_cast<std::size_t>(std::max(px, 0.0F) * m_perPx); };
        const std::size_t left = index(box.left - m_box.left);
        const std::size_t right = index(std::min(box.right, m_box.right) - m_box.left);
        const std::size_t bottom = index(std::min(box.bottom, m_box.bottom) - m_box.top);
        for (std::size_t row = index(box.top - m_box.top); row <= bottom; ++row)
            for (std::size_t cell = row * m_across + left; cell <= row * m_across + right; ++cell)
                if (nearestM <= m_cells[cell].back() + kSeenM)
                    return false;
        return true;
    }

    /// The depth from which on all is hidden wherever a cell's middle is as asked; infinite where one is open.
    template<class Wanted>
    [[nodiscard]] float hidesFrom(const Wanted& wanted) const
    {
        float deepest = 0.0F;
        for (std::size_t i = 0; i < m_cells.size(); ++i) {
            const std::size_t row = i / m_across;
            const glm::vec2 cell(static_cast<float>(i - row * m_across), static_cast<float>(row));
            if (wanted(glm::vec2(m_box.left, m_box.top) + (cell + 0.5F) * m_cellPx))
                deepest = std::max(deepest, m_cells[i].back());
        }
        return deepest + kSeenM;
    }

    /// For kernels that ask hides() of several points at once.
    struct Depths
    {
        PictureBox box;
        float perPx, seenM;
        std::int32_t across;
        const float* cells; ///< [cells][2] The second of each hides.
    };
    [[nodiscard]] Depths depths() const
    {
        return {.box = m_box,
                .perPx = m_perPx,
                .seenM = kSeenM,
                .across = static_cast<std::int32_t>(m_across),
                .cells = m_cells.front().data()};
    }

private:
    static constexpr float kOpen = 1e9F;
    static constexpr float kSeenM = 0.008F; ///< So far behind the foremost hair a lock still shows.
    static constexpr std::size_t kNoCell = ~std::size_t{0};
    using Cell = std::array<float, 2>; ///< The least depths, ascending.

    [[nodiscard]] std::size_t cells(float px) const { return static_cast<std::size_t>(px * m_perPx) + 1; }
    [[nodiscard]] std::size_t cellOf(glm::vec3 seen) const
    {
        if (!(seen.x >= m_box.left) || seen.x > m_box.right || !(seen.y >= m_box.top) || seen.y > m_box.bottom)
            return kNoCell;
        return static_cast<std::size_t>((seen.y - m_box.top) * m_perPx) * m_across +
               static_cast<std::size_t>((seen.x - m_box.left) * m_perPx);
    }
    static void insert(Cell& cell, float depth)
    {
        for (float& one : cell)
            if (depth < one)
                std::swap(one, depth);
    }

    PictureBox m_box;
    float m_cellPx, m_perPx;
    std::size_t m_across;
    std::vector<Cell> m_cells;
};

} // namespace hairpaint::view
