// Edges are matched after welding; rings are found by following them.
#include "sim/skin/mesh_openings.h"

#include "sim/skin/vertex_weld.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <span>

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
    const auto eachEdge = [&](const auto& use) {
        for (const glm::uvec3& triangle : mesh.triangles)
            for (int k = 0; k < 3; ++k) {
                const unsigned from = triangle[k];
                const unsigned to = triangle[(k + 1) % 3];
                if (welded[from] != welded[to])
                    use(from, to);
            }
    };
    // Directed edges by where they begin, counted, summed up and filled in; the one of the neighbour is
    // reversed.
    std::vector<std::size_t> firstOf(welded.size() + 1, 0);
    eachEdge([&](unsigned from, unsigned /*to*/) { ++firstOf[welded[from] + 1]; });
    std::partial_sum(firstOf.begin(), firstOf.end(), firstOf.begin());
    std::vector<unsigned> ends(firstOf.back());
    std::vector<std::size_t> next(firstOf.begin(), firstOf.end() - 1);
    eachEdge([&](unsigned from, unsigned to) { ends[next[welded[from]]++] = welded[to]; });
    std::vector<std::pair<unsigned, unsigned>> open;
    eachEdge([&](unsigned from, unsigned to) {
        const std::span begun =
            std::span(ends).subspan(firstOf[welded[to]], firstOf[welded[to] + 1] - firstOf[welded[to]]);
        if (std::ranges::find(begun, welded[from]) == begun.end())
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
