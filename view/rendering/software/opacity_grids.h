// How much hair lies between a point and the light, and the eye.
#pragma once

#include "view/rendering/eye_grid.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace hairpaint::rendering {

/// Hair's area over the area it covers, summed away from the light and from the eye (after deep opacity maps, Yuksel
/// and Keyser 2008, in even layers). The same for any number of threads: areas are added as whole numbers.
class OpacityGrids
{
public:
    /// Strands of one group.
    struct Source
    {
        const sim::GroupFrame* group;
        std::span<const std::uint32_t> slots;
        float detail; ///< The fraction of the group's hairs that these are.
    };
    /// `fine`: for a picture to be kept.
    void fill(std::span<const Source> sources, const FrameConstants& constants, bool fine);
    [[nodiscard]] const EyeGrid& eyeGrid() const { return m_eyeGrid; }
    /// [kGridSide][kGridSide][kGridSide] voxels in units of 1 / kGridUnits, z running away from the light (0) or the
    /// eye (1). The lower half is the voxel's, the upper half its neighbour's along x, so that one look tells both.
    [[nodiscard]] const std::uint32_t* grid(std::size_t which) const { return m_opacity.at(which).data(); }

private:
    void splat(const Source& source, const FrameConstants& constants, std::size_t part);
    using Row = std::array<std::uint32_t, kGridSide>;
    [[nodiscard]] bool takeRow(std::size_t first, Row& areas);
    void sum(const FrameConstants& constants);

    static constexpr std::size_t kMostParts = 8;
    /// [parts] the voxels of each part; parts are splatted side by side.
    std::vector<std::vector<std::uint32_t>> m_voxels;
    std::array<std::vector<std::uint32_t>, 2> m_opacity;
    EyeGrid m_eyeGrid;
    std::size_t m_hairsWanted = 1;
};

} // namespace hairpaint::rendering
