// The paths of kLanes hairs over the head at once, step by step.
#pragma once

#include "sim/base/strand_blocks.h"
#include "sim/groom/growth_direction.h"
#include "sim/skin/skin_band.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace hairpaint::sim {

inline constexpr float kLongestLayStepM = 0.018F;
inline constexpr float kFurthestLayM = 0.16F; ///< A hair lies along the head no further than this.
inline constexpr float kStandsBelow = 0.15F;  ///< A field less flat than this holds no hair to the head.

/// What a field holds for a cell of the band.
struct LayCell
{
    glm::vec3 normalHd{0.0F}; ///< Normal of the skin, unit.
    float skinM = 0.0F;       ///< dot(normalHd, p) for points p of the skin, which is taken as flat in the cell.
    GrowthDirections directions;
};

/// Constants of kLanes hairs. Hd, m.
struct LayLanes
{
    using Row = std::array<float, kLanes>;
    std::array<Row, 3> rootHd{};
    std::array<Row, 3> directionHd{}; ///< In which it leaves the skin; unit.
    Row segmentM{};
    Row steps{};   ///< Steps per segment.
    Row falls{};   ///< See fallFraction().
    Row coatM{};   ///< Height in the coat at which it lies.
    Row perRise{}; ///< 1/m: one over the length along which the coat rises to its height; 0: at once.
    Row keepsM{};  ///< Length from the root along which it keeps its direction, whatever the field.
    Row lies{};    ///< 1 where it lies on the head at its root, 0 where it stands.
};

/// `nodesHd` [nodes][3][kLanes]; `passed` [kLanes][mostPassed] gets indices of cells, in order. Without cells all hairs
/// are straight. Neither allocates nor throws; the same bytes with every instruction set.
struct LayTask
{
    SkinBand::Grid grid = {};
    const LayCell* cells = nullptr;
    const LayLanes* lanes = nullptr;
    int nodes = 0;
    float* nodesHd = nullptr;
    std::int32_t* passed = nullptr;
    std::size_t mostPassed = 0;
};
void layLanes(const LayTask& task);

} // namespace hairpaint::sim
