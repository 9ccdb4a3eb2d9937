// What lies where in a block of skeletons, sixteen strands at once.
#pragma once

#include "sim/groom/group_settings.h"
#include "view/picking/picture_brush.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace hairpaint::view {

using PickRow = std::array<float, kPickLanes>;

/// A block, and what is looked for in it.
struct BlockQuestion
{
    const float* nodesWo = nullptr; ///< [nodes][3][kPickLanes]
    std::size_t nodes = 0;
    const float* straysM = nullptr; ///< [kPickLanes]
    std::uint32_t lanes = 0;        ///< Bit a lane: strands that count.
    std::uint32_t spans = 0;        ///< Bit a box of HairBoxes: where to look.
    PictureBox box;                 ///< Box in the picture: segments near it are wanted,
    float deepestM = kNoLimitM;     ///< where their curves may lie no deeper than this.
};

/// Segments by the node at their end; of spans that were not looked at nothing is written but that nothing is there.
struct BlockAnswer
{
    /// [nodes][3][kPickLanes] as Lens::seen() gives it.
    std::array<std::array<float, 3 * kPickLanes>, sim::kMostNodes> seen;
    std::array<PickRow, sim::kMostNodes> strayPx;    ///< How far the drawn curve may be from the skeleton there.
    std::array<std::uint32_t, sim::kMostNodes> near; ///< Bit a lane: its curve may meet the box.
    std::uint32_t anyNear;
};

/// Finds the segments before the eye whose boxes, with room for their curves, meet the question's. The same bytes on
/// any machine.
void findNear(const Lens& lens, const BlockQuestion& question, BlockAnswer& answer);

/// A box for each span of the block's strands, without room for curves, and the least depth in it. Nodes behind the eye
/// do not count; no node, an empty box.
void findBoxes(const Lens& lens, const BlockQuestion& question, PictureBox* boxes, float* nearestM);

/// Lens::seen() of so many rows [3][kPickLanes].
void seeRows(const Lens& lens, const float* rowsWo, std::size_t rows, float* seen);
/// For curves as seeRows() gives them: for each point, bit a lane, whether the segment that ends there lies before the
/// eye and its box meets `box`.
void findCurvesNear(const float* seen, std::size_t points, const PictureBox& box, std::uint32_t* near);
/// How far along its curve each point lies: [points][kPickLanes] from [points][3][kPickLanes].
void measureCurves(const float* pointsWo, std::size_t points, float* alongM);

} // namespace hairpaint::view
