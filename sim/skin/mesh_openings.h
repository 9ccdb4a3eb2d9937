// The edges at which a head's mesh ends, and their closing.
#pragma once

#include "sim/skin/head_mesh.h"

#include <utility>
#include <vector>

namespace hairpaint::sim {

/// The edges that have a triangle on one side only, as vertices in that triangle's order. Vertices at the same
/// position, to a millionth of the mesh's size, are taken as one, so a uv seam is no opening.
[[nodiscard]] std::vector<std::pair<unsigned, unsigned>> openEdges(const HeadMesh& mesh);

/// Fills every opening with a flat fan around its middle; for a ring that is about flat, such as a bust's foot. The
/// new triangles cover no uv area.
[[nodiscard]] HeadMesh withOpeningsClosed(HeadMesh mesh);

} // namespace hairpaint::sim
