// Positions that stand together.
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace hairpaint::model {

/// Sets of indices of positions. Those in one cube of a grid, or in cubes that touch, are in one set: positions up to
/// `cellM` apart always are, those further apart than some three and a half never are by themselves. Always in the same
/// order.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> touchingSets(std::span<const glm::vec3> positions, float cellM);

} // namespace hairpaint::model
