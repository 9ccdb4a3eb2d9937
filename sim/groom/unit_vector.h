// Lengths and directions of vectors that may have none.
#pragma once

#include <glm/glm.hpp>

#include <cmath>

namespace hairpaint::sim {

[[nodiscard]] inline float lengthOfVector(glm::vec3 v)
{
    return std::sqrt(glm::dot(v, v));
}

[[nodiscard]] inline glm::vec3 unitVectorOr(glm::vec3 v, glm::vec3 fallback)
{
    const float length = lengthOfVector(v);
    return length > 1e-9F ? v / length : fallback;
}

} // namespace hairpaint::sim
