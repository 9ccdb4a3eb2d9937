// Triangles one after another become an indexed mesh.
#pragma once

#include "model/heads/rigged_mesh.h"

#include <array>
#include <cstdint>
#include <unordered_map>

namespace hairpaint::importer {

struct Corner
{
    glm::vec3 position{0.0F};
    glm::vec3 normal{0.0F}; ///< Any length; zero asks for the triangle's own.
    glm::vec2 uv{0.0F};
    model::BoneWeights bones{}; ///< Where the scene has joints.
    friend bool operator==(const Corner&, const Corner&) = default;
};

/// Joins corners that are equal bit for bit, makes normals unit length, moves each triangle's uvs into 0..1 as one and
/// clamps what still sticks out. Triangles without area or with numbers that are not finite are left out.
class MeshBuilder
{
public:
    void add(std::array<Corner, 3> triangle);
    [[nodiscard]] std::size_t vertexCount() const { return m_mesh.positionsHd.size(); }
    [[nodiscard]] std::size_t triangleCount() const { return m_mesh.triangles.size(); }
    /// With weights, and without joints.
    [[nodiscard]] model::RiggedMesh take() { return std::move(m_mesh); }

private:
    struct CornerHash
    {
        std::size_t operator()(const Corner& corner) const;
    };
    std::uint32_t indexOf(const Corner& corner);

    model::RiggedMesh m_mesh;
    std::unordered_map<Corner, std::uint32_t, CornerHash> m_indices;
};

} // namespace hairpaint::importer
