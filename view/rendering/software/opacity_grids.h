// How much hair lies between a place and the light, and the eye.
#pragma once

#include "view/rendering/frame_constants.h"

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
    void fill(std::span<const Source> sources, const FrameConstants& constants);
    /// [kGridSide][kGridSide][kGridSide] floats, z running away from the light (0) or the eye (1).
    [[nodiscard]] const float* grid(std::size_t which) const { return m_opacity.at(which).data(); }

private:
    void splat(const Source& source, const FrameConstants& constants, std::size_t part);
    void sum(const FrameConstants& constants);

    static constexpr std::size_t kParts = 4; ///< That are splatted side by side.
    std::array<std::vector<std::uint32_t>, kParts> m_voxels;
    std::array<std::vector<float>, 2> m_opacity;
};

} // namespace hairpaint::rendering
