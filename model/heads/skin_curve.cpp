// Drawing, and distances from, curves on the skin.
#include "model/heads/skin_curve.h"

#include "sim/base/rounded.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::heads {

namespace {

glm::vec3 foldedOver(const glm::vec3& p)
{
    return {std::abs(p.x), p.y, p.z};
}

/// Ends in the middle go on as their mirror image.
glm::vec3 beyond(const glm::vec3& end, const glm::vec3& next)
{
    return end.x == 0.0F ? glm::vec3(-next.x, next.y, next.z) : 2.0F * end - next;
}

} // namespace

SkinCurve::SkinCurve(const glm::vec3& centre, const glm::vec3& axis, std::span<const glm::vec3> marks)
    : m_centre(centre), m_axis(glm::normalize(axis)), m_across(glm::cross(glm::vec3(1.0F, 0.0F, 0.0F), m_axis))
{
    constexpr int kSteps = 6;
    for (std::size_t i = 0; i + 1 < marks.size(); ++i) {
        const glm::vec3& p1 = marks[i];
        const glm::vec3& p2 = marks[i + 1];
        const glm::vec3 p0 = i > 0 ? marks[i - 1] : beyond(p1, p2);
        const glm::vec3 p3 = i + 2 < marks.size() ? marks[i + 2] : beyond(p2, p1);
        for (int k = 0; k < kSteps; ++k) {
            const float t = static_cast<float>(k) / static_cast<float>(kSteps);
            add(p1 +
                0.5F * t * (p2 - p0 + t * (2.0F * p0 - 5.0F * p1 + 4.0F * p2 - p3 + t * (3.0F * (p1 - p2) + p3 - p0))));
        }
    }
    add(marks.back());
}

float SkinCurve::distance(const glm::vec3& p, float* along) const
{
    const glm::vec3 fromCentre = foldedOver(p) - m_centre;
    const float radius = glm::length(fromCentre) + 1.0e-12F;
    const glm::vec3 direction = fromCentre / radius;
    float nearest = 8.0F;
    for (std::size_t i = 0; i + 1 < m_directions.size(); ++i) {
        const glm::vec3 edge = m_directions[i + 1] - m_directions[i];
        const glm::vec3 from = direction - m_directions[i];
        const float t = std::clamp(glm::dot(from, edge) / glm::dot(edge, edge), 0.0F, 1.0F);
        const glm::vec3 gap = from - edge * t;
        const float squared = glm::dot(gap, gap);
        if (squared < nearest) {
            nearest = squared;
            if (along != nullptr)
                *along = (static_cast<float>(i) + t) / static_cast<float>(m_directions.size() - 1);
        }
    }
    return radius * 2.0F * sim::asinRounded(0.5F * std::sqrt(nearest));
}

float SkinCurve::signedDistance(const glm::vec3& p) const
{
    const glm::vec2 flattened = flat(glm::normalize(foldedOver(p) - m_centre));
    bool isInside = false;
    for (std::size_t i = 0; i + 1 < m_points.size(); ++i) {
        const glm::vec2& a = m_points[i];
        const glm::vec2& b = m_points[i + 1];
        if ((a.y > flattened.y) != (b.y > flattened.y) &&
            flattened.x < a.x + (b.x - a.x) * (flattened.y - a.y) / (b.y - a.y))
            isInside = !isInside;
    }
    return isInside ? distance(p) : -distance(p);
}

/// Azimuthal equidistant map around the axis.
glm::vec2 SkinCurve::flat(const glm::vec3& direction) const
{
    const glm::vec2 sideways(direction.x, glm::dot(direction, m_across));
    const float sine = glm::length(sideways);
    return sideways * (sim::atan2Rounded(sine, glm::dot(direction, m_axis)) / std::max(sine, 1.0e-12F));
}

void SkinCurve::add(const glm::vec3& mark)
{
    m_directions.push_back(glm::normalize(mark - m_centre));
    m_points.push_back(flat(m_directions.back()));
}

} // namespace hairpaint::heads
