// How far away the skin is in each part of the 3D area's picture.
#pragma once

#include "sim/motion/strand_frame.h"
#include "sim/skin/skin.h"
#include "view/picking/lens.h"

#include <QSize>

#include <vector>

namespace hairpaint::view {

/// A picture of depths, coarser than the view. Immutable. About 2 ms to make for a head of 50,000 triangles.
class SkinDepths
{
public:
    /// `skin` may be null: nothing is hidden.
    SkinDepths(const sim::Skin* skin, const sim::HeadPose& pose, const Lens& lens, QSize size);

    /// Whether skin lies before a point of the picture: px of the view and depth in m. Hair that lies on the skin is
    /// seen.
    [[nodiscard]] bool hides(glm::vec3 seen) const;

    /// For kernels that ask hides() of several points at once.
    struct Samples
    {
        const float* depths; ///< [height][width] 1/m; 0 where there is no skin.
        int width, height;
        float scale; ///< Samples a px.
    };
    [[nodiscard]] Samples samples() const
    {
        return {.depths = m_depths.data(), .width = m_width, .height = m_height, .scale = m_scale};
    }

private:
    [[nodiscard]] float& at(int x, int y)
    {
        return m_depths[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width) + static_cast<std::size_t>(x)];
    }
    void draw(glm::vec3 a, glm::vec3 b, glm::vec3 c);

    int m_width = 0, m_height = 0;
    float m_scale = 1.0F;        ///< Samples a px.
    std::vector<float> m_depths; ///< [height][width] 1/m; 0 where there is no skin.
};

} // namespace hairpaint::view
