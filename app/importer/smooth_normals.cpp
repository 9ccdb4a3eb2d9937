// Vertices of one position, which seams of the layout divide, have one normal.
#include "app/importer/smooth_normals.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace hairpaint::importer {

std::vector<glm::vec3> smoothNormals(const std::vector<glm::vec3>& positions, const std::vector<glm::uvec3>& triangles)
{
    std::vector<glm::vec3> sums(positions.size(), glm::vec3(0.0F));
    for (const glm::uvec3& t : triangles) {
        const glm::vec3 a = positions[t.x];
        const glm::vec3 across = glm::cross(positions[t.y] - a, positions[t.z] - a);
        for (int corner = 0; corner < 3; ++corner)
            sums[t[corner]] += across;
    }
    std::vector<std::uint32_t> order(positions.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto key = [&](std::uint32_t i) {
        // What is no number has no order: it comes last, and is left out later.
        const glm::vec3& p = positions[i];
        return p.x == p.x && p.y == p.y && p.z == p.z;
    };
    const auto last = std::partition(order.begin(), order.end(), key);
    std::sort(order.begin(), last, [&](std::uint32_t a, std::uint32_t b) {
        const glm::vec3& p = positions[a];
        const glm::vec3& q = positions[b];
        if (p.x != q.x)
            return p.x < q.x;
        if (p.y != q.y)
            return p.y < q.y;
        return p.z != q.z ? p.z < q.z : a < b;
    });
    for (auto from = order.begin(); from != last;) {
        auto to = from;
        glm::vec3 sum(0.0F);
        for (; to != last && positions[*to] == positions[*from]; ++to)
            sum += sums[*to];
        for (; from != to; ++from)
            sums[*from] = sum;
    }
    return sums;
}

} // namespace hairpaint::importer
