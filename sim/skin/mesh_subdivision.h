// A finer mesh out of a coarse one and the displacement of its edges' middles.
#pragma once

#include "sim/skin/head_mesh.h"

#include <span>
#include <utility>
#include <vector>

namespace hairpaint::sim {

/// Each edge once, in the order in which the triangles first name it (x to y, y to z, z to x), smaller vertex first.
[[nodiscard]] std::vector<std::pair<unsigned, unsigned>> edgesOf(const HeadMesh& mesh);

/// The middle of an edge and the direction in which it is displaced: the mean of its ends' normals, unit.
struct EdgeMiddle
{
    glm::vec3 positionHd{0.0F};
    glm::vec3 normalHd{0.0F, 1.0F, 0.0F};
};
[[nodiscard]] EdgeMiddle middleOf(const HeadMesh& mesh, const std::pair<unsigned, unsigned>& edge);

/// Every triangle in four, with each edge's middle as a new vertex, moved by its displacement along its normal (m; as
/// many as edgesOf gives). The mesh's own vertices stay as they are, in front of the new ones, whose normals follow the
/// faces around them. uv lies where it did.
[[nodiscard]] HeadMesh subdivided(const HeadMesh& mesh, std::span<const float> displacementsM);
/// Where a middle goes whose surface is known: to the side, too, where it has a crease beside the edge.
struct MovedMiddle
{
    glm::vec3 offsetHd{0.0F};     ///< m, from EdgeMiddle::positionHd.
    glm::vec3 normalOffset{0.0F}; ///< Added to EdgeMiddle::normalHd; the sum is made unit.
};
/// The same with middles that have a normal of their own.
[[nodiscard]] HeadMesh subdivided(const HeadMesh& mesh, std::span<const MovedMiddle> middles);

} // namespace hairpaint::sim
