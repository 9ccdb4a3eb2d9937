// Which vertices of a mesh have one position.
#pragma once

#include "sim/skin/head_mesh.h"

#include <vector>

namespace hairpaint::sim {

/// For each vertex the first one at its position, to a millionth of the mesh's size: the two sides of a uv seam have
/// one position, and may have been rounded differently. Any thread.
[[nodiscard]] std::vector<unsigned> weldedVertices(const HeadMesh& mesh);

} // namespace hairpaint::sim
