// What is checked of parts, wherever they come from.
#include "model/heads/rigged_mesh.h"

#include <algorithm>

namespace hairpaint::model {

namespace {

bool isWithin(const MeshPart& part, std::size_t textures)
{
    const auto inTiles = [](int tile) { return tile >= 0 && tile < MeshPart::kMostTiles; };
    const auto inColours = [](float value) { return value >= 0.0F && value <= 1.0F; };
    return isJointName(part.name) && isJointName(part.material) && inTiles(part.tile.x) && inTiles(part.tile.y) &&
           inColours(part.colour.x) && inColours(part.colour.y) && inColours(part.colour.z) &&
           (part.texture == -1 || (part.texture >= 0 && static_cast<std::size_t>(part.texture) < textures)) &&
           part.vertices > 0 && part.triangles > 0;
}

} // namespace

bool partsFit(const RiggedMesh& mesh)
{
    if (mesh.parts.empty())
        return mesh.textures.empty();
    std::size_t vertex = 0;
    std::size_t triangle = 0;
    for (const MeshPart& part : mesh.parts) {
        if (!isWithin(part, mesh.textures.size()) || part.vertices > mesh.positionsHd.size() - vertex ||
            part.triangles > mesh.triangles.size() - triangle)
            return false;
        const std::size_t end = vertex + part.vertices;
        for (const std::size_t last = triangle + part.triangles; triangle < last; ++triangle) {
            const glm::uvec3& corners = mesh.triangles[triangle];
            if (std::min({corners.x, corners.y, corners.z}) < vertex ||
                std::max({corners.x, corners.y, corners.z}) >= end)
                return false;
        }
        vertex = end;
    }
    return vertex == mesh.positionsHd.size() && triangle == mesh.triangles.size();
}

} // namespace hairpaint::model
