// Ellipsoids that stand for the head in collisions.
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include <vector>

namespace hairpaint::sim {

struct HeadMesh;

/// Hd, m. `rotation` turns the ellipsoid's own axes into Hd.
struct Ellipsoid
{
    glm::vec3 centreHd{0.0F};
    glm::vec3 semiAxesM{0.1F};
    glm::quat rotation{1.0F, 0.0F, 0.0F, 0.0F};
    friend bool operator==(const Ellipsoid&, const Ellipsoid&) = default;
};

/// `count` (1..8) ellipsoids that together follow the mesh from inside, for a head that brings none.
[[nodiscard]] std::vector<Ellipsoid> fitEllipsoids(const HeadMesh& mesh, int count);

} // namespace hairpaint::sim
