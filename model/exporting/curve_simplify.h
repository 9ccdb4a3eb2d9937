// Curves with fewer points.
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace hairpaint::model {

/// Indices of the points to keep, ascending, both ends among them: every point lies within `tolerance` of the segment
/// that replaces it (Ramer 1972; Douglas and Peucker 1973). At most 65,536 points.
void keptPoints(std::span<const glm::vec3> points, float tolerance, std::vector<std::uint16_t>& kept);

} // namespace hairpaint::model
