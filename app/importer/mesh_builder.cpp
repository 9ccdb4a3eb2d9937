// Joining corners into an indexed mesh.
#include "app/importer/mesh_builder.h"

#include "sim/skin/head_limits.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace hairpaint::importer {

namespace {

/// Whole tiles are taken off a uv, and beyond this nothing of the tile itself would be left.
constexpr float kFarthestTile = 1e5F;

bool usable(const Corner& corner)
{
    for (int axis = 0; axis < 3; ++axis)
        if (!(std::abs(corner.position[axis]) <= sim::kFarthestPosition))
            return false;
    return std::abs(corner.uv.x) <= kFarthestTile && std::abs(corner.uv.y) <= kFarthestTile;
}

glm::vec3 unitNormal(const glm::vec3& normal, const glm::vec3& own)
{
    const float square = glm::dot(normal, normal);
    if (!std::isfinite(square) || square < 1e-20F)
        return own;
    return normal / std::sqrt(square);
}

/// Textures repeat: the tile that the triangle's middle lies in becomes 0..1.
void moveIntoUnitSquare(std::array<Corner, 3>& triangle)
{
    const glm::vec2 middle = (triangle[0].uv + triangle[1].uv + triangle[2].uv) / 3.0F;
    const glm::vec2 tile = glm::floor(middle);
    const bool onBorder = std::ranges::all_of(
        triangle, [](const Corner& c) { return c.uv.x >= 0.0F && c.uv.x <= 1.0F && c.uv.y >= 0.0F && c.uv.y <= 1.0F; });
    for (Corner& corner : triangle) {
        if (!onBorder)
            corner.uv -= tile;
        corner.uv = glm::clamp(corner.uv, 0.0F, 1.0F) + 0.0F; // -0 becomes 0
    }
}

} // namespace

std::size_t MeshBuilder::CornerHash::operator()(const Corner& corner) const
{
    std::size_t hash = 0x9E3779B97F4A7C15ULL;
    const auto mix = [&hash](float value) {
        hash = (hash ^ std::bit_cast<std::uint32_t>(value + 0.0F)) * 0xFF51AFD7ED558CCDULL;
        hash ^= hash >> 32U;
    };
    for (int axis = 0; axis < 3; ++axis) {
        mix(corner.position[axis]);
        mix(corner.normal[axis]);
    }
    mix(corner.uv.x);
    mix(corner.uv.y);
    return hash;
}

std::uint32_t MeshBuilder::indexOf(const Corner& corner)
{
    const auto next = static_cast<std::uint32_t>(m_mesh.positionsHd.size());
    const auto [mapped, isNew] = m_indices.try_emplace(corner, next);
    if (isNew) {
        m_mesh.positionsHd.push_back(corner.position);
        m_mesh.normalsHd.push_back(corner.normal);
        m_mesh.uvs.push_back(corner.uv);
        m_mesh.skeleton.weights.push_back(corner.bones);
    }
    return mapped->second;
}

void MeshBuilder::add(std::array<Corner, 3> triangle)
{
    if (!std::ranges::all_of(triangle, usable))
        return;
    const glm::dvec3 a(triangle[0].position);
    const glm::dvec3 across = glm::cross(glm::dvec3(triangle[1].position) - a, glm::dvec3(triangle[2].position) - a);
    const double length = glm::length(across);
    if (!(length > 0.0))
        return;
    moveIntoUnitSquare(triangle);
    const glm::vec3 own(across / length);
    for (Corner& corner : triangle)
        corner.normal = unitNormal(corner.normal, own);
    // One after another: the order of arguments is not fixed.
    const std::uint32_t first = indexOf(triangle[0]);
    const std::uint32_t second = indexOf(triangle[1]);
    m_mesh.triangles.emplace_back(first, second, indexOf(triangle[2]));
}

} // namespace hairpaint::importer
