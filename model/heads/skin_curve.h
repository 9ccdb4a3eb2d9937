// Curves on a head's skin, drawn through points that a hairdresser would mark.
#pragma once

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace hairpaint::heads {

/// A curve seen from a point inside the head: Catmull-Rom through marks on the left side, kept as unit directions; the
/// right side is its mirror image. Immutable; any thread. Hd, m.
class SkinCurve
{
public:
    /// The axis is where a closed curve's flat map is centred; it lies inside the region and has x = 0.
    SkinCurve(const glm::vec3& centre, const glm::vec3& axis, std::span<const glm::vec3> marks);

    /// Metres along the skin, never negative. `along` gets the nearest position on the curve, 0 to 1.
    [[nodiscard]] float distance(const glm::vec3& p, float* along = nullptr) const;
    /// For a curve that starts and ends in the middle: the side on which the axis lies is positive.
    [[nodiscard]] float signedDistance(const glm::vec3& p) const;

private:
    [[nodiscard]] glm::vec2 flat(const glm::vec3& direction) const;
    void add(const glm::vec3& mark);

    glm::vec3 m_centre;
    glm::vec3 m_axis;
    glm::vec3 m_across;
    std::vector<glm::vec3> m_directions;
    std::vector<glm::vec2> m_points;
};

} // namespace hairpaint::heads
