// Per-face measures by the 2 x 2 map from a face's own plane to uv.
#include "bust_measures.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::tests {

glm::vec3 faceCentre(const GlbMesh& mesh, const std::array<std::uint32_t, 3>& triangle)
{
    return (mesh.positions[triangle[0]] + mesh.positions[triangle[1]] + mesh.positions[triangle[2]]) / 3.0F;
}

glm::vec3 faceNormal(const GlbMesh& mesh, const std::array<std::uint32_t, 3>& triangle)
{
    const glm::dvec3 a = mesh.positions[triangle[0]];
    const glm::dvec3 b = mesh.positions[triangle[1]];
    const glm::dvec3 c = mesh.positions[triangle[2]];
    return glm::normalize(glm::cross(b - a, c - a));
}

FaceMeasure measured(const GlbMesh& mesh, const std::array<std::uint32_t, 3>& triangle)
{
    const glm::dvec3 a = mesh.positions[triangle[0]];
    const glm::dvec3 first = glm::dvec3(mesh.positions[triangle[1]]) - a;
    const glm::dvec3 second = glm::dvec3(mesh.positions[triangle[2]]) - a;
    const glm::dvec2 origin = mesh.uvs[triangle[0]];
    const glm::dvec2 firstUv = glm::dvec2(mesh.uvs[triangle[1]]) - origin;
    const glm::dvec2 secondUv = glm::dvec2(mesh.uvs[triangle[2]]) - origin;

    const double length = glm::length(first);
    const double along = glm::dot(second, first) / length;
    const double across = glm::length(glm::cross(first, second)) / length;
    const glm::dvec2 columnX = firstUv / length;
    const glm::dvec2 columnY = (secondUv - columnX * along) / across;
    // The singular values are half the sum and half the difference of these two.
    const double sum = glm::length(glm::dvec2(columnX.x + columnY.y, columnX.y - columnY.x));
    const double difference = glm::length(glm::dvec2(columnX.x - columnY.y, columnX.y + columnY.x));
    const double longest = std::max({length, glm::length(second), glm::distance(first, second)});
    return {.skinArea = 0.5 * length * across,
            .uvArea = 0.5 * (firstUv.x * secondUv.y - firstUv.y * secondUv.x),
            .stretch = (sum + difference) / std::max(std::abs(sum - difference), 1.0e-12),
            .aspect = longest * longest / (length * across)};
}

double quantile(std::vector<std::pair<double, double>> entries, double part)
{
    std::sort(entries.begin(), entries.end());
    double total = 0.0;
    for (const auto& [value, weight] : entries)
        total += weight;
    double below = 0.0;
    for (const auto& [value, weight] : entries) {
        below += weight;
        if (below >= part * total)
            return value;
    }
    return entries.back().first;
}

int doublyCoveredPoints(const GlbMesh& mesh, int resolution)
{
    const auto side = static_cast<std::size_t>(resolution);
    std::vector<int> covers(side * side, 0);
    for (const auto& triangle : mesh.triangles) {
        const glm::dvec2 a = glm::dvec2(mesh.uvs[triangle[0]]) * static_cast<double>(resolution);
        const glm::dvec2 b = glm::dvec2(mesh.uvs[triangle[1]]) * static_cast<double>(resolution);
        const glm::dvec2 c = glm::dvec2(mesh.uvs[triangle[2]]) * static_cast<double>(resolution);
        const auto cross = [](const glm::dvec2& p, const glm::dvec2& q, const glm::dvec2& r) {
            return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
        };
        const auto lowest = [&](double x, double y, double z) {
            return std::max(0, static_cast<int>(std::floor(std::min({x, y, z}))));
        };
        const auto highest = [&](double x, double y, double z) {
            return std::min(resolution - 1, static_cast<int>(std::ceil(std::max({x, y, z}))));
        };
        for (int y = lowest(a.y, b.y, c.y); y <= highest(a.y, b.y, c.y); ++y) {
            for (int x = lowest(a.x, b.x, c.x); x <= highest(a.x, b.x, c.x); ++x) {
                // Off the lattice of the uv values, so that no point lies on an edge of two triangles.
                const glm::dvec2 p(x + 0.4142135, y + 0.7320508);
                const bool isInside = cross(a, b, p) > 0.0 && cross(b, c, p) > 0.0 && cross(c, a, p) > 0.0;
                covers[static_cast<std::size_t>(y) * side + static_cast<std::size_t>(x)] += isInside ? 1 : 0;
            }
        }
    }
    return static_cast<int>(std::count_if(covers.begin(), covers.end(), [](int count) { return count > 1; }));
}

} // namespace hairpaint::tests
