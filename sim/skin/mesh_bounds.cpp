// One pass over the vertices.
#include "sim/skin/mesh_bounds.h"

namespace hairpaint::sim {

MeshBounds boundsOf(const HeadMesh& mesh)
{
    if (mesh.positionsHd.empty())
        return {};
    MeshBounds bounds{.least = mesh.positionsHd.front(), .greatest = mesh.positionsHd.front()};
    for (const glm::vec3& p : mesh.positionsHd) {
        bounds.least = glm::min(bounds.least, p);
        bounds.greatest = glm::max(bounds.greatest, p);
    }
    return bounds;
}

} // namespace hairpaint::sim
