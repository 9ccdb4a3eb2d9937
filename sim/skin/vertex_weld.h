// Which vertices of a mesh are one place.
#pragma once

#include "sim/skin/head_mesh.h"

#include <vector>

namespace hairpaint::sim {

/// For each vertex the first one at its place, to a millionth of the mesh's size: the two sides of a uv seam are one
/// place, and may have been rounded differently. Any thread.
[[nodiscard]] std::vector<unsigned> weldedVertices(const HeadMesh& mesh);

} // namespace hairpaint::sim
