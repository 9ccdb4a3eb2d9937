// HeadOcclusion as kernels read it.
#pragma once

#include <array>

namespace hairpaint::rendering {

/// Cells of the finest level, and of as many coarser ones twice as wide each.
inline constexpr int kOcclusionCellSp = 8;
inline constexpr int kOcclusionLevels = 4;

/// A cell's value counts for it and its neighbours to the right, above and both, so that what is no
/// larger than a cell takes one look.
struct OcclusionCells
{
    const float* beyondM = nullptr; ///< Distances along the view beyond which no hair is seen; null: there is no head.
    int across = 0;                 ///< Cells from a row to the next, in every level.
    std::array<int, kOcclusionLevels> firstRow{}; ///< Of each level.
};

} // namespace hairpaint::rendering
