// Sides across the strand and the outward direction.
#include "model/exporting/ribbon.h"

#include "model/exporting/unit_vectors.h"

#include <algorithm>

namespace hairpaint::model {

void ribbonFrames(std::span<const glm::vec3> points, const glm::vec3& middle, std::vector<RibbonFrame>& frames)
{
    // Where the strand runs straight outward, any side is as good: it keeps the one before.
    constexpr float kSteepSine = 0.2F;
    frames.resize(points.size());
    glm::vec3 tangent(0.0F, 1.0F, 0.0F);
    glm::vec3 side(0.0F);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::vec3& before = points[i > 0 ? i - 1 : 0];
        const glm::vec3& after = points[std::min(i + 1, points.size() - 1)];
        tangent = unitOr(after - before, tangent);
        const glm::vec3 outward = unitOr(points[i] - middle, tangent);
        const glm::vec3 across = glm::cross(tangent, outward);
        const bool isSteep = glm::dot(across, across) < kSteepSine * kSteepSine;
        const glm::vec3 kept = side - glm::dot(side, tangent) * tangent;
        const glm::vec3 last = unitOr(kept, anyAcross(tangent));
        const glm::vec3 next = isSteep ? last : glm::normalize(across);
        side = i > 0 && glm::dot(next, last) < 0.0F ? -next : next;
        frames[i] = {.side = side, .normal = glm::normalize(glm::cross(side, tangent))};
    }
}

} // namespace hairpaint::model
