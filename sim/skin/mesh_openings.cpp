// Edges are matched after welding; rings are found by following them.
#include "sim/skin/mesh_openings.h"

#include "sim/skin/vertex_weld.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

namespace hairpaint::sim {

namespace {

void addFan(HeadMesh& mesh, const std::vector<unsigned>& ring)
{
    glm::vec3 middle(0.0F);
    for (const unsigned vertex : ring)
        middle += mesh.positionsHd[vertex] / static_cast<float>(ring.size());
    glm::vec3 area(0.0F);
    for (std::size_t i = 0; i < ring.size(); ++i)
        area += glm::cross(mesh.positionsHd[ring[(i + 1) % ring.size()]] - middle, mesh.positionsHd[ring[i]] - middle);
    const float size = std::sqrt(glm::dot(area, area));
    if (size <= 0.0F)
        return;
    const auto first = static_cast<unsigned>(mesh.positionsHd.size());
    const glm::vec2 uv = mesh.uvs[ring.front()];
    const auto add = [&](glm::vec3 positionHd) {
        mesh.positionsHd.push_back(positionHd);
        mesh.normalsHd.push_back(area / size);
        mesh.uvs.push_back(uv);
        if (!mesh.marks.empty())
            mesh.marks.emplace_back();
    };
    for (const unsigned vertex : ring)
        add(glm::vec3(mesh.positionsHd[vertex]));
    add(middle);
    const auto count = static_cast<unsigned>(ring.size());
    for (unsigned i = 0; i < count; ++i)
        mesh.triangles.emplace_back(first + (i + 1) % count, first + i, first + count);
}

} // namespace

std::vector<std::pair<unsigned, unsigned>> openEdges(const HeadMesh& mesh)
{
    const std::vector<unsigned> welded = weldedVertices(mesh);
    std::vector<std::uint64_t> edges; // Directed; the one of the neighbour runs the other way.
    edges.reserve(mesh.triangles.size() * 3);
    const auto eachEdge = [&](const auto& use) {
        for (const glm::uvec3& triangle : mesh.triangles)
            for (int k = 0; k < 3; ++k) {
                const unsigned from = triangle[k];
                const unsigned to = triangle[(k + 1) % 3];
                if (welded[from] != welded[to])
                    use(from, to);
            }
    };
    const auto key = [&](unsigned from, unsigned to) {
        return (static_cast<std::uint64_t>(welded[from]) << 32U) | welded[to];
    };
    eachEdge([&](unsigned from, unsigned to) { edges.push_back(key(from, to)); });
    std::sort(edges.begin(), edges.end());
    std::vector<std::pair<unsigned, unsigned>> open;
    eachEdge([&](unsigned from, unsigned to) {
        if (!std::binary_search(edges.begin(), edges.end(), key(to, from)))
            open.emplace_back(from, to);
    });
    return open;
}

HeadMesh withOpeningsClosed(HeadMesh mesh)
{
    const std::vector<unsigned> welded = weldedVertices(mesh);
    std::multimap<unsigned, unsigned> next; // Between welded vertices.
    for (const auto& [from, to] : openEdges(mesh))
        next.emplace(welded[from], welded[to]);
    while (!next.empty()) {
        std::vector<unsigned> ring;
        for (auto at = next.begin(); at != next.end(); at = next.find(ring.back())) {
            ring.push_back(at->second);
            next.erase(at);
        }
        if (ring.size() >= 3)
            addFan(mesh, ring);
    }
    return mesh;
}

} // namespace hairpaint::sim
