// Splats strands into voxels and sums the columns, as grid_splat.comp and grid_sum.comp do.
#include "view/rendering/software/opacity_grids.h"

#include "sim/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hairpaint::rendering {
namespace {

constexpr float kVoxelAreaM2 = 1e-9F;       ///< Hair's area that one unit of a voxel stands for.
constexpr std::size_t kSplatStrands = 6144; ///< About as many are enough for a smooth grid.
constexpr std::size_t kVoxelsOfGrid = static_cast<std::size_t>(kGridSide) * kGridSide * kGridSide;

std::uint32_t hashOf(std::uint32_t x)
{
    x ^= x >> 16U;
    x *= 0x7FEB352DU;
    x ^= x >> 15U;
    x *= 0x846CA68BU;
    return x ^ (x >> 16U);
}

/// In voxels.
glm::vec3 inVoxels(const glm::mat4& gridFromWo, glm::vec3 wo)
{
    return glm::vec3(gridFromWo * glm::vec4(wo, 1.0F)) * static_cast<float>(kGridSide);
}

void addTo(std::uint32_t* voxels, glm::vec3 place, std::uint32_t area)
{
    const auto along = [](float p) {
        return static_cast<std::size_t>(std::clamp(p, 0.0F, static_cast<float>(kGridSide) - 0.5F));
    };
    voxels[(along(place.z) * kGridSide + along(place.y)) * kGridSide + along(place.x)] += area;
}

} // namespace

void OpacityGrids::fill(std::span<const Source> sources, const FrameConstants& constants)
{
    for (std::vector<std::uint32_t>& voxels : m_voxels)
        voxels.resize(2 * kVoxelsOfGrid, 0);
    for (std::vector<float>& opacity : m_opacity)
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
    std::uint32_t* voxels = m_voxels.at(part).data();
    const sim::Groom& groom = *source.group->groom;
    const std::size_t step = std::max<std::size_t>(1, source.slots.size() / kSplatStrands);
    const float weight = groom.settings.material.widthM * static_cast<float>(step) / (source.detail * kVoxelAreaM2);
    const auto nodes = static_cast<std::size_t>(groom.nodes);
    const sim::StrandBlocks layout = groom.blocks();
    for (std::size_t i = part * step; i < source.slots.size(); i += kParts * step) {
        const std::uint32_t slot = source.slots[i];
        const std::size_t strand = groom.frameStrand(slot);
        glm::vec3 a = layout.node(source.group->positions, strand, 0);
        std::array<glm::vec3, 2> from{inVoxels(constants.gridFromWo[0], a), inVoxels(constants.gridFromWo[1], a)};
        for (std::size_t k = 1; k < nodes; ++k) {
            const glm::vec3 b = layout.node(source.group->positions, strand, k);
            const std::array<glm::vec3, 2> to{inVoxels(constants.gridFromWo[0], b),
                                              inVoxels(constants.gridFromWo[1], b)};
            const float longest = std::max(glm::distance(from[0], to[0]), glm::distance(from[1], to[1]));
            const int steps = std::clamp(static_cast<int>(std::min(longest, 8.0F)) + 1, 1, 8);
            const auto area =
                static_cast<std::uint32_t>(std::floor(glm::distance(a, b) * weight / static_cast<float>(steps) + 0.5F));
            for (int n = 0; n < steps; ++n) {
                const std::uint32_t random = hashOf(static_cast<std::uint32_t>(strand) * 64U +
                                                    static_cast<std::uint32_t>(k) * 8U + static_cast<std::uint32_t>(n));
                const glm::vec3 jitter =
                    glm::vec3(static_cast<float>(random & 0x3FFU), static_cast<float>((random >> 10U) & 0x3FFU),
                              static_cast<float>((random >> 20U) & 0x3FFU)) *
                        (1.0F / 1024.0F) -
                    0.5F;
                const float t = (static_cast<float>(n) + 0.5F) / static_cast<float>(steps);
                addTo(voxels, from[0] + (to[0] - from[0]) * t + jitter, area);
                addTo(voxels + kVoxelsOfGrid, from[1] + (to[1] - from[1]) * t + jitter, area);
            }
            a = b;
            from = to;
        }
    }
}

/// Sums each column from the light or the eye on, and clears the voxels for the next picture.
void OpacityGrids::sum(const FrameConstants& constants)
{
    constexpr std::size_t kRows = 2 * static_cast<std::size_t>(kGridSide);
    constexpr std::size_t kSlice = static_cast<std::size_t>(kGridSide) * kGridSide;
    sim::parallelFor(kRows, 8, [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
            const std::size_t grid = row / kGridSide;
            const float unit = kVoxelAreaM2 / constants.gridSize[static_cast<int>(grid)];
            const std::size_t first = grid * kVoxelsOfGrid + row % kGridSide * kGridSide;
            float* opacity = m_opacity.at(grid).data() + row % kGridSide * kGridSide;
            std::array<float, kGridSide> sums{};
            for (std::size_t z = 0; z < kGridSide; ++z)
                for (std::size_t x = 0; x < kGridSide; ++x) {
                    std::uint32_t area = 0;
                    for (std::vector<std::uint32_t>& voxels : m_voxels)
                        area += std::exchange(voxels[first + z * kSlice + x], 0U);
                    const float here = static_cast<float>(area) * unit;
                    opacity[z * kSlice + x] = sums.at(x) + 0.5F * here;
                    sums.at(x) += here;
                }
        }
    });
}

} // namespace hairpaint::rendering
