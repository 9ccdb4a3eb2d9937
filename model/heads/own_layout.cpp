// Charts by the six directions of the axes, on shelves.
#include "model/heads/own_layout.h"

#include "sim/skin/vertex_weld.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace hairpaint::model {

namespace {

constexpr float kMargin = 0.004F; ///< Between charts, of the map's side.

/// Triangles that hang together and look in the same direction.
struct Chart
{
    std::vector<std::size_t> triangles;
    glm::vec2 least{1e30F};
    glm::vec2 greatest{-1e30F};
    glm::vec2 at{0.0F}; ///< Where its corner comes to lie.
    [[nodiscard]] glm::vec2 size() const { return greatest - least; }
};

glm::vec3 normalOf(const sim::HeadMesh& mesh, const glm::uvec3& t)
{
    return glm::cross(mesh.positionsHd[t.y] - mesh.positionsHd[t.x], mesh.positionsHd[t.z] - mesh.positionsHd[t.x]);
}

/// 0..5: the axis that it looks along most, and its sign.
int directionOf(const glm::vec3& normal)
{
    const glm::vec3 length = glm::abs(normal);
    const int axis = length.x >= length.y && length.x >= length.z ? 0 : length.y >= length.z ? 1 : 2;
    return 2 * axis + (normal[axis] < 0.0F ? 1 : 0);
}

glm::vec2 flat(const glm::vec3& position, int direction)
{
    const float sign = direction % 2 == 0 ? 1.0F : -1.0F;
    switch (direction / 2) {
    case 0:
        return {-sign * position.z, position.y};
    case 1:
        return {sign * position.x, -position.z};
    default:
        return {sign * position.x, position.y};
    }
}

std::size_t rootOf(std::vector<std::size_t>& parents, std::size_t i)
{
    while (parents[i] != i)
        i = parents[i] = parents[parents[i]];
    return i;
}

std::vector<Chart> chartsOf(const sim::HeadMesh& mesh, const std::vector<int>& directions)
{
    const std::vector<unsigned> welded = sim::weldedVertices(mesh);
    std::vector<std::size_t> parents(mesh.triangles.size());
    std::iota(parents.begin(), parents.end(), std::size_t{0});
    std::map<std::pair<unsigned, unsigned>, std::vector<std::size_t>> byEdge;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (int side = 0; side < 3; ++side) {
            const unsigned a = welded[mesh.triangles[t][side]];
            const unsigned b = welded[mesh.triangles[t][(side + 1) % 3]];
            std::vector<std::size_t>& others = byEdge[std::minmax(a, b)];
            for (const std::size_t other : others)
                if (directions[other] == directions[t])
                    parents[rootOf(parents, t)] = rootOf(parents, other);
            others.push_back(t);
        }
    std::map<std::size_t, Chart> charts;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        Chart& chart = charts[rootOf(parents, t)];
        chart.triangles.push_back(t);
        for (int corner = 0; corner < 3; ++corner) {
            const glm::vec2 at = flat(mesh.positionsHd[mesh.triangles[t][corner]], directions[t]);
            chart.least = glm::min(chart.least, at);
            chart.greatest = glm::max(chart.greatest, at);
        }
    }
    std::vector<Chart> listed;
    listed.reserve(charts.size());
    for (auto& [root, chart] : charts)
        listed.push_back(std::move(chart));
    std::ranges::stable_sort(listed, std::greater(), [](const Chart& chart) { return chart.size().y; });
    return listed;
}

/// Whether they have room at that scale.
bool layOnShelves(std::vector<Chart>& charts, float scale)
{
    glm::vec2 corner(kMargin);
    float shelf = 0.0F;
    for (Chart& chart : charts) {
        const glm::vec2 size = scale * chart.size() + kMargin;
        if (corner.x + size.x > 1.0F) {
            corner = {kMargin, corner.y + shelf};
            shelf = 0.0F;
        }
        if (corner.x + size.x > 1.0F || corner.y + size.y > 1.0F)
            return false;
        chart.at = corner;
        corner.x += size.x;
        shelf = std::max(shelf, size.y);
    }
    return true;
}

} // namespace

RiggedMesh withOwnLayout(const RiggedMesh& source)
{
    std::vector<int> directions;
    directions.reserve(source.triangles.size());
    for (const glm::uvec3& t : source.triangles)
        directions.push_back(directionOf(normalOf(source, t)));
    std::vector<Chart> charts = chartsOf(source, directions);
    float fitting = 0.0F;
    float tooLarge = 0.0F;
    for (const Chart& chart : charts)
        tooLarge = std::max({tooLarge, chart.size().x, chart.size().y});
    tooLarge = tooLarge > 0.0F ? 1.0F / tooLarge : 1.0F;
    constexpr int kSteps = 24;
    for (int i = 0; i < kSteps; ++i) {
        const float scale = fitting > 0.0F ? 0.5F * (fitting + tooLarge) : tooLarge;
        if (layOnShelves(charts, scale))
            fitting = scale;
        else
            tooLarge = fitting > 0.0F ? scale : 0.7F * scale;
    }
    (void)layOnShelves(charts, fitting);

    RiggedMesh made;
    made.skeleton.joints = source.skeleton.joints;
    made.told = source.told;
    std::vector<std::uint32_t> copies(source.positionsHd.size());
    std::vector<std::size_t> lastChart(source.positionsHd.size(), charts.size());
    for (std::size_t i = 0; i < charts.size(); ++i)
        for (const std::size_t t : charts[i].triangles) {
            glm::uvec3 triangle(0);
            for (int corner = 0; corner < 3; ++corner) {
                const std::uint32_t vertex = source.triangles[t][corner];
                if (lastChart[vertex] != i) {
                    lastChart[vertex] = i;
                    copies[vertex] = static_cast<std::uint32_t>(made.positionsHd.size());
                    made.positionsHd.push_back(source.positionsHd[vertex]);
                    made.normalsHd.push_back(source.normalsHd[vertex]);
                    const glm::vec2 at = flat(source.positionsHd[vertex], directions[t]);
                    made.uvs.push_back(
                        glm::clamp(charts[i].at + fitting * (at - charts[i].least), glm::vec2(0.0F), glm::vec2(1.0F)));
                    if (!source.skeleton.empty())
                        made.skeleton.weights.push_back(source.skeleton.weights[vertex]);
                }
                triangle[corner] = copies[vertex];
            }
            made.triangles.push_back(triangle);
        }
    return made;
}

} // namespace hairpaint::model
