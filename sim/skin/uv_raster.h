// Which texels of a square map a triangle covers by its uvs. Any thread.
#pragma once

#include "sim/skin/head_mesh.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::sim {

/// Calls visit(row * side + column) for texels whose middles lie inside, rows from v = 0 up; those in the border of
/// `inside` of its height from each side are left out. Of uvs beyond 0..1 only what lies within.
template<typename Visit>
void eachTexelOf(const HeadMesh& mesh, const glm::uvec3& triangle, int side, const Visit& visit, float inside = 0.0F)
{
    const auto scale = static_cast<float>(side);
    const glm::vec2 a = mesh.uvs[triangle.x] * scale;
    const glm::vec2 b = mesh.uvs[triangle.y] * scale;
    const glm::vec2 c = mesh.uvs[triangle.z] * scale;
    const auto across = [](const glm::vec2& p, const glm::vec2& q) { return p.x * q.y - p.y * q.x; };
    const float area = across(b - a, c - a);
    if (area == 0.0F || !std::isfinite(area))
        return;
    const auto bounded = [side](float value) {
        return static_cast<int>(std::floor(std::clamp(value, 0.0F, static_cast<float>(side - 1))));
    };
    const int left = bounded(std::min({a.x, b.x, c.x}) - 0.5F);
    const int right = bounded(std::max({a.x, b.x, c.x}) + 0.5F);
    const int low = bounded(std::min({a.y, b.y, c.y}) - 0.5F);
    const int high = bounded(std::max({a.y, b.y, c.y}) + 0.5F);
    for (int y = low; y <= high; ++y)
        for (int x = left; x <= right; ++x) {
            const glm::vec2 p(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
            const float wa = across(c - b, p - b) / area;
            const float wb = across(a - c, p - c) / area;
            if (wa > inside && wb > inside && 1.0F - wa - wb > inside)
                visit(static_cast<std::size_t>(y) * static_cast<std::size_t>(side) + static_cast<std::size_t>(x));
        }
}

} // namespace hairpaint::sim
