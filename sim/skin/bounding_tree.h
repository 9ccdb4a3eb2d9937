// A bounding volume tree over a mesh's faces: the first face on a ray, the nearest to a point.
#pragma once

#include "sim/skin/going_on.h"
#include "sim/skin/head_mesh.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace hairpaint::sim {

/// A point on a face, as the tree finds it.
struct FacePoint
{
    std::uint32_t face = 0;
    glm::vec3 barycentric{1.0F, 0.0F, 0.0F};
    float distance = 0.0F; ///< Along the ray, in lengths of its direction (m where that is unit), or from the point, m.
};

/// Keeps no reference to the mesh: every method is given the one that the tree was built from. Immutable. Equally near
/// faces: the one with the lowest index.
class BoundingTree
{
public:
    /// Splits at the median of the longest axis; O(n log n). Where `goingOn` is refused the tree is of no use.
    BoundingTree(const HeadMesh& mesh, GoingOn& goingOn);

    [[nodiscard]] std::optional<FacePoint> firstHit(const HeadMesh& mesh, glm::vec3 origin, glm::vec3 direction) const;
    /// None for a mesh without faces.
    [[nodiscard]] std::optional<FacePoint> nearest(const HeadMesh& mesh, glm::vec3 point) const;

private:
    /// A leaf holds `count` faces from m_faces[first]; an inner node (count 0) has its children at first and first + 1.
    struct Node
    {
        glm::vec3 lowest;
        std::uint32_t first;
        glm::vec3 highest;
        std::uint32_t count;
    };
    struct Builder;

    std::vector<Node> m_nodes;
    std::vector<std::uint32_t> m_faces;
};

} // namespace hairpaint::sim
