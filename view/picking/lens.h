// The projection of the 3D area, for strands as they lie in blocks.
#pragma once

#include "sim/base/strand_blocks.h"
#include "view/rendering/scene.h"

#include <QPointF>
#include <QSizeF>

#include <algorithm>
#include <cmath>

namespace hairpaint::view {

inline constexpr auto kPickLanes = static_cast<std::size_t>(sim::kLanes);
inline constexpr float kOnSkinM = 0.004F; ///< Hair no further behind the skin than this lies on it and is seen.

[[nodiscard]] inline glm::vec2 pictureVec(QPointF point)
{
    return {static_cast<float>(point.x()), static_cast<float>(point.y())};
}
/// Twice the area of the triangle that two sides span.
[[nodiscard]] inline float crossed(glm::vec2 a, glm::vec2 b)
{
    return a.x * b.y - a.y * b.x;
}

/// x, y: px of the view; z: distance from the eye along its view, m; 0 or less behind the eye.
class Lens
{
public:
    Lens(const rendering::Camera& camera, QSizeF size)
        : m_view(camera.view()),
          m_half(0.5F * static_cast<float>(size.width()), 0.5F * static_cast<float>(size.height())),
          m_px(m_half.y / std::tan(camera.fieldOfViewRad / 2.0F))
    {}

    [[nodiscard]] glm::vec3 seen(glm::vec3 positionWo) const
    {
        const glm::vec4 inView = m_view * glm::vec4(positionWo, 1.0F);
        const float depth = -inView.z;
        const float scale = pxPerM(depth);
        return {m_half.x + inView.x * scale, m_half.y - inView.y * scale, depth};
    }
    /// px of a metre across the view at that depth.
    [[nodiscard]] float pxPerM(float depthM) const { return m_px / std::max(depthM, kNearestM); }

    /// For kernels: seen() is half + (x, -y) in the view * px / depth.
    static constexpr float kNearestM = 1e-4F;
    [[nodiscard]] const glm::mat4& view() const { return m_view; }
    [[nodiscard]] glm::vec2 half() const { return m_half; }
    [[nodiscard]] float px() const { return m_px; }

private:
    glm::mat4 m_view;
    glm::vec2 m_half;
    float m_px;
};

} // namespace hairpaint::view
