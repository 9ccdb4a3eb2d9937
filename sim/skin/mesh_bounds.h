// The box around a head's mesh.
#pragma once

#include "sim/skin/head_mesh.h"

namespace hairpaint::sim {

/// Hd, m. All 0 for a mesh without vertices.
struct MeshBounds
{
    glm::vec3 least{0.0F};
    glm::vec3 greatest{0.0F};
    [[nodiscard]] glm::vec3 size() const { return greatest - least; }
};

[[nodiscard]] MeshBounds boundsOf(const HeadMesh& mesh);

} // namespace hairpaint::sim
