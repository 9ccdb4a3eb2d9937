// A coarser mesh for what varies slowly over a fine one.
#pragma once

#include "sim/skin/head_mesh.h"

#include <cstddef>
#include <vector>

namespace hairpaint::sim {

/// Vertices that are near and whose normals agree are one. Only positions and triangles are there.
struct CoarseMesh
{
    HeadMesh mesh;
    std::vector<unsigned> clusterOf; ///< By vertex of the fine mesh.
};

/// With at most `mostVertices` (1 or more), by cells of a grid; triangles whose corners fall together are gone. The
/// same mesh gives the same one. Any thread.
[[nodiscard]] CoarseMesh coarsened(const HeadMesh& mesh, std::size_t mostVertices);

} // namespace hairpaint::sim
