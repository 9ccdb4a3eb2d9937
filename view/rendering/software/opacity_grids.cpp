// Splats strands into voxels and sums the columns, as grid_splat.comp and grid_sum.comp do.
#include "view/rendering/software/opacity_grids.h"

#include "sim/base/parallel.h"
#include "view/rendering/light/hair_light.h"

#include <algorithm>
#include <utility>

namespace hairpaint::rendering {
namespace {

constexpr float kVoxelAreaM2 = 1e-9F;       ///< Hair's area that one unit of a voxel stands for.
constexpr std::size_t kSplatStrands = 6144; ///< About as many are enough for a smooth grid.
constexpr std::size_t kVoxelsOfGrid = static_cast<std::size_t>(kGridSide) * kGridSide * kGridSide;

} // namespace

void OpacityGrids::fill(std::span<const Source> sources, const FrameConstants& constants)
{
    m_eyeGrid = rendering::eyeGrid(constants);
    for (std::vector<std::uint32_t>& voxels : m_voxels)
        voxels.resize(2 * kVoxelsOfGrid, 0);
    for (std::vector<std::uint32_t>& opacity : m_opacity)
        opacity.resize(kVoxelsOfGrid);
    sim::parallelFor(kParts, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t part = begin; part < end; ++part)
            for (const Source& source : sources)
                splat(source, constants, part);
    });
    sum(constants);
}

void OpacityGrids::splat(const Source& source, const FrameConstants& constants, std::size_t part)
{
    const sim::Groom& groom = *source.group->groom;
    const std::size_t step = std::max<std::size_t>(1, source.slots.size() / kSplatStrands);
    splatStrands({.gridFromWo = constants.gridFromWo[0],
                  .projectionFromWo = constants.projectionFromWo,
                  .eyeGrid = m_eyeGrid,
                  .group = source.group,
                  .slots = source.slots,
                  .first = part * step,
                  .step = kParts * step,
                  .nodes = groom.nodes,
                  .weight = groom.settings.material.widthM * static_cast<float>(step) / (source.detail * kVoxelAreaM2)},
                 m_voxels.at(part).data());
}

/// Sums each column from the light or the eye on, and clears the voxels for the next picture.
void OpacityGrids::sum(const FrameConstants& constants)
{
    constexpr std::size_t kRows = 2 * static_cast<std::size_t>(kGridSide);
    constexpr float kMostUnits = 65535.0F;
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
            for (std::size_t z = 0; z < kGridSide; ++z) {
                std::array<std::uint32_t, kGridSide + 1> units{};
                for (std::size_t x = 0; x < kGridSide; ++x) {
                    std::uint32_t area = 0;
                    for (std::vector<std::uint32_t>& voxels : m_voxels)
                        area += std::exchange(voxels[first + z * kSlice + x], 0U);
                    const float here = static_cast<float>(area) * unit;
                    const float rounded = (sums.at(x) + 0.5F * here) * kGridUnits + 0.5F;
                    units.at(x) = static_cast<std::uint32_t>(std::min(rounded, kMostUnits));
                    sums.at(x) += here;
                }
                units.back() = units.at(kGridSide - 1);
                for (std::size_t x = 0; x < kGridSide; ++x)
                    opacity[z * kSlice + x] = units.at(x) | units.at(x + 1) << 16U;
            }
        }
    });
}

} // namespace hairpaint::rendering
