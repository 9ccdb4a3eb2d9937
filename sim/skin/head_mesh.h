// A head's triangle mesh as the simulation, the renderer and the paint area share it.
#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace hairpaint::sim {

/// Triangles with one position, normal and uv a vertex (vertices on a uv seam are split).
/// Hd space: metres, right-handed, y up, face toward +z. uv: 0..1, v up. Immutable once shared between threads.
struct HeadMesh
{
    std::vector<glm::vec3> positionsHd;
    std::vector<glm::vec3> normalsHd; ///< Unit length, outward.
    std::vector<glm::vec2> uvs;
    std::vector<glm::uvec3> triangles; ///< Counter-clockwise from outside.
};

} // namespace hairpaint::sim
