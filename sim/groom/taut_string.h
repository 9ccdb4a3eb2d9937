// The points of a string drawn taut over the skin.
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstddef>

namespace hairpaint::sim {

inline constexpr std::size_t kStringPoints = 13;
inline constexpr float kStringClearanceM = 0.0005F; ///< Distance of a string from the skin.

/// Root first, about evenly spaced. Hd, m.
struct TautString
{
    std::array<glm::vec3, kStringPoints> pointsHd;
};

} // namespace hairpaint::sim
