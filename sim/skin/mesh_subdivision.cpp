// One round of splitting.
#include "sim/skin/mesh_subdivision.h"

#include <algorithm>
#include <cstdint>
#include <unordered_map>

namespace hairpaint::sim {

namespace {

using Edge = std::pair<unsigned, unsigned>;

Edge edgeOf(const glm::uvec3& triangle, int corner)
{
    return std::minmax(triangle[corner], triangle[(corner + 1) % 3]);
}

std::uint64_t keyOf(const Edge& edge)
{
    return (std::uint64_t{edge.first} << 32U) | edge.second;
}

} // namespace

std::vector<Edge> edgesOf(const HeadMesh& mesh)
{
    std::vector<Edge> edges;
    std::unordered_map<std::uint64_t, unsigned> known;
    for (const glm::uvec3& triangle : mesh.triangles)
        for (int corner = 0; corner < 3; ++corner) {
            const Edge edge = edgeOf(triangle, corner);
            if (known.emplace(keyOf(edge), 0U).second)
                edges.push_back(edge);
        }
    return edges;
}

EdgeMiddle middleOf(const HeadMesh& mesh, const Edge& edge)
{
    const glm::vec3 sum = mesh.normalsHd[edge.first] + mesh.normalsHd[edge.second];
    const float length = glm::length(sum);
    return {.positionHd = 0.5F * (mesh.positionsHd[edge.first] + mesh.positionsHd[edge.second]),
            .normalHd = length > 1e-6F ? sum / length : mesh.normalsHd[edge.first]};
}

namespace {

/// `middleAt(i)`: where the middle of edges[i] lies.
template<typename MiddleAt>
HeadMesh split(const HeadMesh& mesh, const std::vector<Edge>& edges, const MiddleAt& middleAt)
{
    const auto first = static_cast<unsigned>(mesh.positionsHd.size());
    HeadMesh fine = mesh;
    std::unordered_map<std::uint64_t, unsigned> vertices;
    vertices.reserve(edges.size());
    for (std::size_t i = 0; i < edges.size(); ++i) {
        vertices.emplace(keyOf(edges[i]), first + static_cast<unsigned>(i));
        fine.positionsHd.push_back(middleAt(i));
        fine.normalsHd.emplace_back(0.0F);
        fine.uvs.push_back(0.5F * (mesh.uvs[edges[i].first] + mesh.uvs[edges[i].second]));
    }
    fine.triangles.clear();
    for (const glm::uvec3& t : mesh.triangles) {
        const auto middle = [&](int corner) { return vertices.at(keyOf(edgeOf(t, corner))); };
        const glm::uvec3 middles(middle(0), middle(1), middle(2));
        fine.triangles.emplace_back(t.x, middles.x, middles.z);
        fine.triangles.emplace_back(middles.x, t.y, middles.y);
        fine.triangles.emplace_back(middles.z, middles.y, t.z);
        fine.triangles.push_back(middles);
    }
    for (const glm::uvec3& t : fine.triangles) {
        const glm::vec3& a = fine.positionsHd[t.x];
        const glm::vec3 area = glm::cross(fine.positionsHd[t.y] - a, fine.positionsHd[t.z] - a);
        for (int corner = 0; corner < 3; ++corner)
            if (t[corner] >= first)
                fine.normalsHd[t[corner]] += area;
    }
    for (std::size_t i = first; i < fine.normalsHd.size(); ++i) {
        const float length = glm::length(fine.normalsHd[i]);
        fine.normalsHd[i] = length > 0.0F ? fine.normalsHd[i] / length : middleOf(mesh, edges[i - first]).normalHd;
    }
    return fine;
}

} // namespace

HeadMesh subdivided(const HeadMesh& mesh, std::span<const float> displacementsM)
{
    const std::vector<Edge> edges = edgesOf(mesh);
    return split(mesh, edges, [&](std::size_t i) {
        const EdgeMiddle middle = middleOf(mesh, edges[i]);
        return middle.positionHd + displacementsM[i] * middle.normalHd;
    });
}

HeadMesh subdivided(const HeadMesh& mesh, std::span<const MovedMiddle> middles)
{
    const std::vector<Edge> edges = edgesOf(mesh);
    HeadMesh fine =
        split(mesh, edges, [&](std::size_t i) { return middleOf(mesh, edges[i]).positionHd + middles[i].offsetHd; });
    for (std::size_t i = 0; i < edges.size(); ++i)
        fine.normalsHd[mesh.normalsHd.size() + i] =
            glm::normalize(middleOf(mesh, edges[i]).normalHd + middles[i].normalOffset);
    return fine;
}

} // namespace hairpaint::sim
