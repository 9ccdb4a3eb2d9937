// A head's triangle mesh as the simulation, the renderer and the paint area share it.
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace hairpaint::sim {

/// What a vertex's skin looks like, each 0..255 for 0..1.
struct SkinMarks
{
    std::uint8_t sky = 255; ///< How much of the hemisphere over it the head itself leaves open, weighed by the cosine.
    std::uint8_t lips = 0;
    std::uint8_t lids = 0;
    std::uint8_t blush = 0; ///< How much blood shines through.
};

/// Triangles with one position, normal and uv a vertex (vertices on a uv seam are split).
/// Hd space: metres, right-handed, y up, face toward +z. uv: 0..1, v up. Immutable once shared between threads.
struct HeadMesh
{
    std::vector<glm::vec3> positionsHd;
    std::vector<glm::vec3> normalsHd; ///< Unit length, outward.
    std::vector<glm::vec2> uvs;
    std::vector<glm::uvec3> triangles; ///< Counter-clockwise from outside.
    std::vector<SkinMarks> marks = {}; ///< One a vertex, or none where they are not known.
};

} // namespace hairpaint::sim
