// Splats strands into voxels and sums the columns, as grid_splat.comp and grid_sum.comp do.
#include "view/rendering/software/opacity_grids.h"

#include "sim/base/parallel.h"
#include "view/rendering/drawn_fraction.h"
#include "view/rendering/light/hair_light.h"
#include "view/rendering/software/splat_kernel.h"

#include <algorithm>
#include <utility>

namespace hairpaint::rendering {
namespace {

constexpr float kVoxelAreaM2 = 1e-9F; ///< Hair's area that one unit of a voxel stands for.
constexpr float kMostUnits = 65535.0F;
constexpr std::uint32_t kMostArea = 0x7FFFFFFF;
constexpr std::size_t kVoxelsOfGrid = static_cast<std::size_t>(kGridSide) * kGridSide * kGridSide;

} // namespace

void OpacityGrids::fill(std::span<const Source> sources, const FrameConstants& constants, bool fine)
{
    m_hairsWanted = hairsForGrids(constants, fine);
    m_eyeGrid = rendering::eyeGrid(constants);
    const std::size_t parts = std::clamp<std::size_t>(static_cast<std::size_t>(sim::threadCount()), 1, kMostParts);
    m_voxels.resize(parts);
    for (std::vector<std::uint32_t>& voxels : m_voxels)
        voxels.resize(2 * kVoxelsOfGrid, 0);
    for (std::vector<std::uint32_t>& opacity : m_opacity)
        opacity.resize(kVoxelsOfGrid);
    sim::parallelFor(parts, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t part = begin; part < end; ++part)
            for (const Source& source : sources)
                splat(source, constants, part);
    });
    sum(constants);
}

void OpacityGrids::splat(const Source& source, const FrameConstants& constants, std::size_t part)
{
    const sim::Groom& groom = *source.group->groom;
    const std::size_t step = std::max<std::size_t>(1, (source.slots.size() + m_hairsWanted / 2) / m_hairsWanted);
    splatStrands({.gridFromWo = constants.gridFromWo[0],
                  .projectionFromWo = constants.projectionFromWo,
                  .eyeGrid = m_eyeGrid,
                  .group = source.group,
                  .slots = source.slots,
                  .first = part * step,
                  .step = m_voxels.size() * step,
                  .nodes = groom.nodes,
                  .weight = groom.settings.material.widthM * static_cast<float>(step) / (source.detail * kVoxelAreaM2)},
                 m_voxels.at(part).data());
}

/// Adds up a row of all parts, and clears it for the next picture. False where nothing is in it.
bool OpacityGrids::takeRow(std::size_t first, Row& areas)
{
    areas.fill(0);
    std::uint32_t any = 0;
    for (std::vector<std::uint32_t>& voxels : m_voxels) {
        std::uint32_t* row = voxels.data() + first;
        for (std::size_t x = 0; x < kGridSide; ++x) {
            areas[x] += row[x];
            any |= row[x];
        }
        std::fill_n(row, kGridSide, 0U);
    }
    return any != 0;
}

/// Sums each column from the light or the eye on.
void OpacityGrids::sum(const FrameConstants& constants)
{
    constexpr std::size_t kRows = 2 * static_cast<std::size_t>(kGridSide);
    constexpr std::size_t kSlice = static_cast<std::size_t>(kGridSide) * kGridSide;
    sim::parallelFor(kRows, 8, [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
            const std::size_t grid = row / kGridSide;
            const float sectionM2 =
                grid == 0 ? constants.gridSize.x : m_eyeGrid.sectionM2 * m_eyeGrid.middleM * m_eyeGrid.middleM;
            const float unit = kVoxelAreaM2 / sectionM2;
            const std::size_t first = grid * kVoxelsOfGrid + row % kGridSide * kGridSide;
            std::uint32_t* opacity = m_opacity.at(grid).data() + row % kGridSide * kGridSide;
            std::array<float, kGridSide> sums{};
            Row areas;
            std::array<std::int32_t, kGridSide + 1> units{};
            for (std::size_t z = 0; z < kGridSide; ++z) {
                const bool any = takeRow(first + z * kSlice, areas);
                for (std::size_t x = 0; x < kGridSide; ++x) {
                    // Vectors have no conversion of what has no sign.
                    const auto area = static_cast<std::int32_t>(std::min(areas[x], kMostArea));
                    const float all = any ? static_cast<float>(area) * unit : 0.0F;
                    const float here = grid == 1 ? std::min(all, kMostWithinVoxel) : all;
                    units[x] =
                        static_cast<std::int32_t>(std::min((sums[x] + 0.5F * here) * kGridUnits + 0.5F, kMostUnits));
                    sums[x] += grid == 1 ? std::min(here, kMostOfVoxel) : here;
                }
                units.back() = units[kGridSide - 1];
                for (std::size_t x = 0; x < kGridSide; ++x)
                    opacity[z * kSlice + x] =
                        static_cast<std::uint32_t>(units[x]) | static_cast<std::uint32_t>(units[x + 1]) << 16U;
            }
        }
    });
}

} // namespace hairpaint::rendering
