// Scan conversion of a closed or nearly closed mesh.
#include "sim/skin/solid_grid.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hairpaint::sim {

namespace {

/// Toggles, for every ray along `axis` that a triangle crosses, the cells behind the crossing.
void scanTriangle(const SolidGrid& grid, const std::array<glm::vec3, 3>& corners, int axis,
                  std::vector<std::uint8_t>& odd)
{
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    std::array<glm::vec3, 3> p{};
    glm::vec2 low(1e30F);
    glm::vec2 high(-1e30F);
    for (std::size_t i = 0; i < 3; ++i) {
        p[i] = (corners[i] - grid.originHd) / grid.cellM;
        low = glm::min(low, glm::vec2(p[i][u], p[i][v]));
        high = glm::max(high, glm::vec2(p[i][u], p[i][v]));
    }
    const auto across = [&](const glm::vec3& a, const glm::vec3& b, float x, float y) {
        return (b[u] - a[u]) * (y - a[v]) - (b[v] - a[v]) * (x - a[u]);
    };
    const float area = across(p[0], p[1], p[2][u], p[2][v]);
    if (area == 0.0F)
        return;
    const int u0 = std::max(0, static_cast<int>(std::ceil(low.x)));
    const int v0 = std::max(0, static_cast<int>(std::ceil(low.y)));
    const int u1 = std::min(grid.size[u] - 1, static_cast<int>(std::floor(high.x)));
    const int v1 = std::min(grid.size[v] - 1, static_cast<int>(std::floor(high.y)));
    for (int y = v0; y <= v1; ++y) {
        for (int x = u0; x <= u1; ++x) {
            const auto fx = static_cast<float>(x);
            const auto fy = static_cast<float>(y);
            const float a = across(p[1], p[2], fx, fy) / area;
            const float b = across(p[2], p[0], fx, fy) / area;
            const float c = 1.0F - a - b;
            if (a < 0.0F || b < 0.0F || c < 0.0F)
                continue;
            const float hit = a * p[0][axis] + b * p[1][axis] + c * p[2][axis];
            glm::ivec3 cell(0);
            cell[u] = x;
            cell[v] = y;
            for (cell[axis] = std::max(0, static_cast<int>(std::ceil(hit))); cell[axis] < grid.size[axis]; ++cell[axis])
                odd[grid.indexOf(cell)] ^= 1U;
        }
    }
}

} // namespace

SolidGrid solidGridOf(const HeadMesh& mesh, int cells, GoingOn& goingOn)
{
    SolidGrid grid;
    if (mesh.positionsHd.empty())
        return grid;
    glm::vec3 low = mesh.positionsHd.front();
    glm::vec3 high = low;
    for (const glm::vec3& p : mesh.positionsHd) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    const glm::vec3 extent = high - low;
    grid.cellM = std::max({extent.x, extent.y, extent.z, 1e-6F}) / static_cast<float>(cells);
    for (int i = 0; i < 3; ++i)
        grid.size[i] = static_cast<int>(extent[i] / grid.cellM) + 3;
    // A little aside, so that rays do not run through vertices of a mesh that is regular itself.
    const glm::vec3 slack = glm::vec3(grid.size - 1) * grid.cellM - extent;
    grid.originHd = low - slack * 0.5F + glm::vec3(0.0137F, 0.0211F, 0.0089F) * grid.cellM;
    const auto count = static_cast<std::size_t>(grid.size.x) * static_cast<std::size_t>(grid.size.y) *
                       static_cast<std::size_t>(grid.size.z);
    std::vector<std::uint8_t> alongX(count, 0);
    std::vector<std::uint8_t> alongZ(count, 0);
    for (const glm::uvec3& t : mesh.triangles) {
        if (!goingOn.after(1))
            return {};
        const std::array<glm::vec3, 3> corners{mesh.positionsHd[t.x], mesh.positionsHd[t.y], mesh.positionsHd[t.z]};
        scanTriangle(grid, corners, 0, alongX);
        scanTriangle(grid, corners, 2, alongZ);
    }
    grid.inside.resize(count);
    for (std::size_t i = 0; i < count; ++i)
        grid.inside[i] = alongX[i] & alongZ[i];
    return grid;
}

std::vector<int> depthsOf(const SolidGrid& grid, const std::vector<std::uint8_t>& marked)
{
    // Two sweeps of a chamfer: along each axis from both ends.
    std::vector<int> depth(marked.size(), 0);
    const auto sweep = [&](int from) {
        glm::ivec3 step;
        for (step.z = 0; step.z < grid.size.z; ++step.z) {
            for (step.y = 0; step.y < grid.size.y; ++step.y) {
                for (step.x = 0; step.x < grid.size.x; ++step.x) {
                    const glm::ivec3 cell = from > 0 ? step : grid.size - 1 - step;
                    const std::size_t index = grid.indexOf(cell);
                    if (marked[index] == 0)
                        continue;
                    int least = from > 0 ? 1 << 20 : depth[index];
                    for (int axis = 0; axis < 3; ++axis) {
                        glm::ivec3 neighbour = cell;
                        neighbour[axis] -= from;
                        const bool outside = neighbour[axis] < 0 || neighbour[axis] >= grid.size[axis];
                        least = std::min(least, outside ? 1 : depth[grid.indexOf(neighbour)] + 1);
                    }
                    depth[index] = least;
                }
            }
        }
    };
    sweep(1);
    sweep(-1);
    return depth;
}

} // namespace hairpaint::sim
