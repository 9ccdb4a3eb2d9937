// From a grid's layout.
#include "sim/skin/skin_field.h"

namespace hairpaint::sim {

SkinField skinFieldOf(const DistanceGrid& grid)
{
    constexpr float kDiagonal = 1.7320508F; // Nowhere does a distance change faster than the position.
    const GridLayout& layout = grid.layout();
    const float unitsACell = layout.cellM / DistanceGrid::kUnitM;
    return {.pairs = grid.pairs().data(),
            .origin = {layout.originHd.x, layout.originHd.y, layout.originHd.z},
            .last = {static_cast<float>(layout.size.x - 1), static_cast<float>(layout.size.y - 1),
                     static_cast<float>(layout.size.z - 1)},
            .cellM = layout.cellM,
            .inverseCell = 1.0F / layout.cellM,
            .row = layout.size.x,
            .slice = layout.size.x * layout.size.y,
            .unitsACell = unitsACell,
            .unitsADiagonal = kDiagonal * unitsACell};
}

} // namespace hairpaint::sim
