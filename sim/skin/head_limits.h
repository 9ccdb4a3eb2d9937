// How large a head's mesh may be: every reader of meshes checks it against these before it becomes a skin.
#pragma once

#include "sim/skin/head_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace hairpaint::sim {

inline constexpr std::uint32_t kMostVertices = 2'000'000;
inline constexpr std::uint32_t kMostTriangles = 4'000'000;
inline constexpr float kFarthestPosition = 1e7F; ///< Each coordinate, in the source's own units.
/// Each coordinate of a uv. Maps lie in 0..1; what lies outside is shown, and painted at the maps' borders.
inline constexpr float kFarthestUv = 1000.0F;

/// Counts that match, indices in range, positions and uvs within the limits and so finite. Normals are not looked at.
[[nodiscard]] inline bool withinLimits(const HeadMesh& mesh)
{
    // Comparisons are false for NaN.
    const auto near = [](const auto& v, float most) {
        for (int axis = 0; axis < v.length(); ++axis)
            if (!(std::abs(v[axis]) <= most))
                return false;
        return true;
    };
    const std::size_t vertices = mesh.positionsHd.size();
    return vertices >= 1 && vertices <= kMostVertices && mesh.normalsHd.size() == vertices &&
           mesh.uvs.size() == vertices && !mesh.triangles.empty() && mesh.triangles.size() <= kMostTriangles &&
           std::ranges::all_of(mesh.positionsHd, [&](const glm::vec3& p) { return near(p, kFarthestPosition); }) &&
           std::ranges::all_of(mesh.uvs, [&](const glm::vec2& uv) { return near(uv, kFarthestUv); }) &&
           std::ranges::all_of(mesh.triangles, [vertices](const glm::uvec3& t) {
               return t.x < vertices && t.y < vertices && t.z < vertices;
           });
}

} // namespace hairpaint::sim
