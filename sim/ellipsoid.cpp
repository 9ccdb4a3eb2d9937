// Fitting ellipsoids to a mesh.
#include "sim/ellipsoid.h"

#include "sim/head_mesh.h"

namespace hairpaint::sim {

std::vector<Ellipsoid> fitEllipsoids(const HeadMesh& mesh, int /*count*/)
{
    if (mesh.positionsHd.empty())
        return {};
    glm::vec3 low = mesh.positionsHd.front();
    glm::vec3 high = low;
    for (const glm::vec3& p : mesh.positionsHd) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    return {{(low + high) * 0.5F, (high - low) * 0.5F, glm::quat(1.0F, 0.0F, 0.0F, 0.0F)}};
}

} // namespace hairpaint::sim
