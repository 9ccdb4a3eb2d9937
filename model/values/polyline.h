// Positions along a line of straight pieces.
#pragma once

#include <glm/glm.hpp>

#include <span>

namespace hairpaint::model {

/// The position `alongM` along it; its end where that is nearer. At least one point.
[[nodiscard]] inline glm::vec3 pointAlong(std::span<const glm::vec3> points, float alongM)
{
    for (std::size_t i = 1; i < points.size(); ++i) {
        const float segmentM = glm::distance(points[i - 1], points[i]);
        if (alongM <= segmentM && segmentM > 0.0F)
            return points[i - 1] + (points[i] - points[i - 1]) * (alongM / segmentM);
        alongM -= segmentM;
    }
    return points.back();
}

} // namespace hairpaint::model
