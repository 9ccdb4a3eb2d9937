// Unit vectors where a vector may have no direction. Any thread.
#pragma once

#include <glm/glm.hpp>

namespace hairpaint::model {

/// `instead` where it is too short to have a direction.
[[nodiscard]] inline glm::vec3 unitOr(const glm::vec3& vector, const glm::vec3& instead)
{
    constexpr float kShortest = 1e-12F;
    const float square = glm::dot(vector, vector);
    return square > kShortest ? vector / glm::sqrt(square) : instead;
}

/// Some unit vector at right angles to a unit vector.
[[nodiscard]] inline glm::vec3 anyAcross(const glm::vec3& unit)
{
    const glm::vec3 axis = glm::abs(unit.x) < 0.7F ? glm::vec3(1.0F, 0.0F, 0.0F) : glm::vec3(0.0F, 1.0F, 0.0F);
    return glm::normalize(glm::cross(unit, axis));
}

} // namespace hairpaint::model
