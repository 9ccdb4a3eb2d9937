// Positions are rounded, sorted and compared.
#include "sim/skin/vertex_weld.h"

#include "sim/skin/mesh_bounds.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

namespace hairpaint::sim {

std::vector<unsigned> weldedVertices(const HeadMesh& mesh)
{
    constexpr float kTolerance = 1e-6F; // Fraction of the mesh's greatest extent.
    const glm::vec3 size = boundsOf(mesh).size();
    const float cell = std::max(kTolerance * std::max({size.x, size.y, size.z}), 1e-9F);
    using Cell = std::tuple<std::int64_t, std::int64_t, std::int64_t>;
    std::vector<std::pair<Cell, unsigned>> cells;
    cells.reserve(mesh.positionsHd.size());
    for (unsigned i = 0; i < mesh.positionsHd.size(); ++i) {
        const glm::vec3& p = mesh.positionsHd[i];
        cells.emplace_back(Cell(std::llround(p.x / cell), std::llround(p.y / cell), std::llround(p.z / cell)), i);
    }
    std::sort(cells.begin(), cells.end());
    std::vector<unsigned> welded(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i)
        welded[cells[i].second] =
            i > 0 && cells[i].first == cells[i - 1].first ? welded[cells[i - 1].second] : cells[i].second;
    return welded;
}

} // namespace hairpaint::sim
