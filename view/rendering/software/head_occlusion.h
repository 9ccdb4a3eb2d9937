// What the head surely hides: a hierarchical depth buffer (Greene, Kass and Miller 1993) that hair is tested against
// before it is lit.
#pragma once

#include "view/rendering/software/occlusion_cells.h"
#include "view/rendering/software/tile_kernel.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace hairpaint::rendering {

class HeadOcclusion
{
public:
    /// The head's picture. Rows are `width` long, from the lowest on.
    struct Picture
    {
        int width = 0;
        int height = 0;
        const HeadSample* samples = nullptr;
        const float* distancesM = nullptr;
        const std::uint8_t* worn = nullptr; ///< 1 where a solid is seen; null: nowhere.
    };

    void resize(int width, int height);
    /// Fills the finest cells of the rows of samples firstRow..endRow, which begin with a cell; `anyHead`: whether a
    /// head may be there. Rows of other cells may be filled on other threads meanwhile.
    void fillRows(const Picture& picture, int firstRow, int endRow, bool anyHead);
    /// Makes the coarser cells, after all rows.
    void combine();
    [[nodiscard]] OcclusionCells cells() const
    {
        return {.beyondM = m_beyondM.data(), .across = m_across, .firstRow = m_firstRow};
    }

private:
    int m_across = 0;
    int m_up = 0;
    std::array<int, kOcclusionLevels> m_firstRow{};
    std::vector<float> m_beyondM;
};

} // namespace hairpaint::rendering
