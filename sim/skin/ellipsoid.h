// Ellipsoids that stand for the head in collisions.
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include <functional>
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

/// At most `count` (1..8) ellipsoids that together follow the mesh from inside, for a head that brings none: fewer
/// where one more would add next to nothing, none for a mesh without an inside. The mesh may be open at the base. Some
/// 0.1 s. `goesOn` is told how far it is (0..1); where it returns false, what was found by then comes back.
[[nodiscard]] std::vector<Ellipsoid> fitEllipsoids(const HeadMesh& mesh, int count,
                                                   const std::function<bool(double)>& goesOn = {});

} // namespace hairpaint::sim
