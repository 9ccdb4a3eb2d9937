// Small generated heads for tests.
#pragma once

#include "sim/base/rounded.h"
#include "sim/skin/head_mesh.h"

#include <cmath>
#include <cstdint>

namespace hairpaint::test {

/// Adds the two triangles of each cell of a grid of (columns + 1) x (rows + 1) vertices that lie row by row.
inline void addGridTriangles(sim::HeadMesh& mesh, int columns, int rows)
{
    const auto index = [columns](int column, int row) {
        return static_cast<std::uint32_t>(row * (columns + 1) + column);
    };
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const std::uint32_t a = index(column, row);
            const std::uint32_t b = index(column + 1, row);
            const std::uint32_t c = index(column + 1, row + 1);
            const std::uint32_t d = index(column, row + 1);
            mesh.triangles.emplace_back(a, b, c);
            mesh.triangles.emplace_back(a, c, d);
        }
    }
}

/// A ball around the origin. u runs round the y axis (0.5 at +z, the face), v from the lowest point to the crown, so
/// there is a seam at the back and the poles are pinched. Triangles: 2 * segments * (segments / 2), some of no area.
inline sim::HeadMesh makeBallHead(int segments = 48, float radiusM = 0.1F)
{
    constexpr float kPi = 3.14159265F;
    sim::HeadMesh mesh;
    const int rows = segments / 2;
    for (int row = 0; row <= rows; ++row) {
        const float v = static_cast<float>(row) / static_cast<float>(rows);
        const float latitude = (v - 0.5F) * kPi;
        for (int column = 0; column <= segments; ++column) {
            const float u = static_cast<float>(column) / static_cast<float>(segments);
            const float longitude = (u - 0.5F) * 2.0F * kPi;
            const glm::vec3 normal(sim::cosRounded(latitude) * sim::sinRounded(longitude), sim::sinRounded(latitude),
                                   sim::cosRounded(latitude) * sim::cosRounded(longitude));
            mesh.positionsHd.push_back(normal * radiusM);
            mesh.normalsHd.push_back(normal);
            mesh.uvs.emplace_back(u, v);
        }
    }
    addGridTriangles(mesh, segments, rows);
    return mesh;
}

/// A square patch in the plane z = 0 that faces +z; uv is its x and y over the side, so a texel is everywhere as large.
inline sim::HeadMesh makePatchHead(int segments = 16, float sideM = 0.2F)
{
    sim::HeadMesh mesh;
    for (int row = 0; row <= segments; ++row) {
        for (int column = 0; column <= segments; ++column) {
            const glm::vec2 uv = glm::vec2(column, row) / static_cast<float>(segments);
            mesh.positionsHd.emplace_back((uv.x - 0.5F) * sideM, (uv.y - 0.5F) * sideM, 0.0F);
            mesh.normalsHd.emplace_back(0.0F, 0.0F, 1.0F);
            mesh.uvs.push_back(uv);
        }
    }
    addGridTriangles(mesh, segments, segments);
    return mesh;
}

} // namespace hairpaint::test
