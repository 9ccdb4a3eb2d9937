// Normals of meshes that come without.
#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace hairpaint::importer {

/// One a vertex, of any length: of all triangles around its position, by their area.
[[nodiscard]] std::vector<glm::vec3> smoothNormals(const std::vector<glm::vec3>& positions,
                                                   const std::vector<glm::uvec3>& triangles);

} // namespace hairpaint::importer
