// Nodes' transforms applied, triangles joined.
#include "app/importer/scene_flattener.h"

#include "app/importer/mesh_builder.h"
#include "app/importer/scene_skeleton.h"
#include "sim/skin/head_limits.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <tuple>

namespace hairpaint::importer {

namespace {

constexpr unsigned kDeepestNode = 256;

/// What the scene holds, for the reason of a refusal.
struct Found
{
    bool triangles = false;
    bool uvs = false;
};

struct Part
{
    model::MeshPart told;
    MeshBuilder builder;
};

class SceneFlattener
{
public:
    SceneFlattener(const ForeignScene& scene, SceneSkeleton& skeleton) : m_scene(scene), m_skeleton(skeleton) {}

    /// False where the limits are passed.
    bool addNode(int index, const glm::mat4& parent, unsigned depth)
    {
        if (depth > kDeepestNode)
            return false;
        const SceneNode& node = m_scene.nodes[static_cast<std::size_t>(index)];
        const glm::mat4 toWorld = parent * node.toParent;
        for (const int mesh : node.meshes)
            if (!addMesh(m_scene.meshes[static_cast<std::size_t>(mesh)], index, toWorld))
                return false;
        for (const int child : node.children)
            if (!addNode(child, toWorld, depth + 1))
                return false;
        return true;
    }
    [[nodiscard]] const Found& found() const { return m_found; }
    std::vector<Part> takeParts() { return std::move(m_parts); }

private:
    bool addMesh(const SceneMesh& mesh, int node, const glm::mat4& nodeToWorld)
    {
        m_found.triangles = m_found.triangles || !mesh.triangles.empty();
        if (mesh.triangles.empty())
            return true;
        m_found.uvs = m_found.uvs || !mesh.uvs.empty();
        const glm::mat4 toWorld = m_skeleton.meshToWorld(mesh, nodeToWorld);
        const std::vector<model::BoneWeights> bones = m_skeleton.weightsOf(mesh, node, toWorld);
        const glm::mat3 turned(toWorld);
        // A mirrored node turns triangles inside out.
        const bool mirrored = glm::determinant(turned) < 0.0F;
        const glm::mat3 forNormals = glm::transpose(glm::inverse(turned));
        const bool inTiles = liesInTiles(mesh);
        for (const glm::uvec3& indices : mesh.triangles) {
            std::array<Corner, 3> triangle;
            for (int corner = 0; corner < 3; ++corner) {
                const std::uint32_t vertex = indices[mirrored ? 2 - corner : corner];
                Corner& own = triangle.at(static_cast<std::size_t>(corner));
                own.position = glm::vec3(toWorld * glm::vec4(mesh.positions[vertex], 1.0F));
                own.normal = forNormals * mesh.normals[vertex];
                if (!mesh.uvs.empty())
                    own.uv = mesh.uvs[vertex];
                if (!bones.empty())
                    own.bones = bones[vertex];
            }
            MeshBuilder& builder = builderOf(mesh, node, inTiles ? tileOf(triangle) : glm::ivec2(0));
            const std::size_t vertices = builder.vertexCount();
            const std::size_t triangles = builder.triangleCount();
            builder.add(triangle);
            m_vertices += builder.vertexCount() - vertices;
            m_triangles += builder.triangleCount() - triangles;
            if (m_vertices > sim::kMostVertices || m_triangles > sim::kMostTriangles)
                return false;
        }
        return true;
    }
    [[nodiscard]] static glm::ivec2 tileOf(const std::array<Corner, 3>& triangle)
    {
        return {glm::floor((triangle[0].uv + triangle[1].uv + triangle[2].uv) / 3.0F)};
    }
    /// Whether its layout lies in tiles as UDIM has them, and not over a texture that repeats: triangles keep to
    /// theirs.
    [[nodiscard]] static bool liesInTiles(const SceneMesh& mesh)
    {
        constexpr float kOver = 1e-3F;
        constexpr std::size_t kFewPercent = 1;
        if (mesh.uvs.empty())
            return false;
        std::size_t across = 0;
        for (const glm::uvec3& indices : mesh.triangles) {
            const std::array uvs{mesh.uvs[indices.x], mesh.uvs[indices.y], mesh.uvs[indices.z]};
            const glm::vec2 tile = glm::floor((uvs[0] + uvs[1] + uvs[2]) / 3.0F);
            constexpr auto kMost = static_cast<float>(model::MeshPart::kMostTiles);
            if (!(tile.x >= 0.0F && tile.y >= 0.0F && tile.x < kMost && tile.y < kMost))
                return false;
            across += std::ranges::any_of(uvs, [&tile](const glm::vec2& uv) {
                const glm::vec2 in = uv - tile;
                return in.x < -kOver || in.y < -kOver || in.x > 1.0F + kOver || in.y > 1.0F + kOver;
            });
        }
        return 100 * across <= kFewPercent * mesh.triangles.size();
    }
    MeshBuilder& builderOf(const SceneMesh& mesh, int node, glm::ivec2 tile)
    {
        const std::string& nodeName = m_scene.nodes[static_cast<std::size_t>(node)].name;
        const std::string& name = nodeName.empty() ? mesh.name : nodeName;
        const bool hasMaterial =
            mesh.material >= 0 && static_cast<std::size_t>(mesh.material) < m_scene.materials.size();
        if (m_last.mesh == &mesh && m_last.node == node && m_last.tile == tile)
            return m_parts[m_last.part].builder;
        const Key key(name, hasMaterial ? mesh.material : -1, tile.x, tile.y, !mesh.uvs.empty());
        const auto [known, isNew] = m_byKey.try_emplace(key, std::min(m_parts.size(), model::MeshPart::kMost - 1));
        if (isNew && m_parts.size() < model::MeshPart::kMost) {
            Part& part = m_parts.emplace_back();
            part.told.name = model::jointNameOf(name);
            part.told.tile = tile;
            if (hasMaterial) {
                const SceneMaterial& material = m_scene.materials[static_cast<std::size_t>(mesh.material)];
                part.told.material = model::jointNameOf(material.name);
                part.told.colour = glm::clamp(material.colour, 0.0F, 1.0F);
                part.told.alpha = material.alpha;
                part.told.doubleSided = material.doubleSided;
                part.told.texture = mesh.uvs.empty() ? -1 : material.image; // An index into the scene's images for now.
            }
        }
        m_last = {.mesh = &mesh, .node = node, .tile = tile, .part = known->second};
        return m_parts[known->second].builder;
    }

    /// What makes triangles one part: the object's name, the material, the tile (two numbers), and whether they have
    /// uvs.
    using Key = std::tuple<std::string, int, int, int, bool>;
    struct Last
    {
        const SceneMesh* mesh = nullptr;
        int node = -1;
        glm::ivec2 tile{0};
        std::size_t part = 0;
    };
    const ForeignScene& m_scene;
    SceneSkeleton& m_skeleton;
    std::map<Key, std::size_t> m_byKey;
    Last m_last;
    std::size_t m_vertices = 0;
    std::size_t m_triangles = 0;
    std::vector<Part> m_parts;
    Found m_found;
};

/// One part after another.
model::RiggedMesh joined(std::vector<Part> parts)
{
    model::RiggedMesh whole;
    for (Part& part : parts) {
        model::RiggedMesh own = part.builder.take();
        if (own.triangles.empty())
            continue;
        const auto first = static_cast<std::uint32_t>(whole.positionsHd.size());
        part.told.vertices = static_cast<std::uint32_t>(own.positionsHd.size());
        part.told.triangles = static_cast<std::uint32_t>(own.triangles.size());
        // Where all are one there is nothing to paint on.
        part.told.hasLayout =
            std::ranges::any_of(own.uvs, [&own](const glm::vec2& uv) { return uv != own.uvs.front(); });
        const auto append = [](auto& to, auto& from) { to.insert(to.end(), from.begin(), from.end()); };
        append(whole.positionsHd, own.positionsHd);
        append(whole.normalsHd, own.normalsHd);
        append(whole.uvs, own.uvs);
        append(whole.skeleton.weights, own.skeleton.weights);
        for (const glm::uvec3& triangle : own.triangles)
            whole.triangles.push_back(triangle + first);
        whole.parts.push_back(std::move(part.told));
    }
    return whole;
}

} // namespace

tl::expected<model::RiggedMesh, wire::Refusal> flattened(const ForeignScene& scene, bool needsUvs)
{
    SceneSkeleton skeleton(scene);
    SceneFlattener flattener(scene, skeleton);
    if (!flattener.addNode(0, glm::mat4(1.0F), 0))
        return tl::unexpected(wire::Reason::TooLarge);
    if (!flattener.found().triangles)
        return tl::unexpected(wire::Reason::NoTriangles);
    if (needsUvs && !flattener.found().uvs)
        return tl::unexpected(wire::Reason::NoUvs);
    model::RiggedMesh mesh = joined(flattener.takeParts());
    if (mesh.triangles.empty())
        return tl::unexpected(wire::Reason::NoTriangles);
    if (!wire::meshFits(mesh))
        return tl::unexpected(wire::Refusal(wire::Reason::Malformed, "its numbers are no positions of a mesh"));
    mesh.skeleton.joints = skeleton.joints().joints;
    // A head without its skeleton is better than none.
    if (mesh.skeleton.empty() || !model::withinLimits(mesh.skeleton, mesh.positionsHd.size()))
        mesh.skeleton = {};
    mesh.told = scene.told;
    return mesh;
}

} // namespace hairpaint::importer
