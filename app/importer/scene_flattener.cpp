// Nodes' transforms applied, triangles joined.
#include "app/importer/scene_flattener.h"

#include "app/importer/mesh_builder.h"
#include "app/importer/scene_skeleton.h"
#include "sim/skin/head_limits.h"

#include <array>

namespace hairpaint::importer {

namespace {

constexpr unsigned kDeepestNode = 256;

/// What the scene holds, for the reason of a refusal.
struct Found
{
    bool triangles = false;
    bool uvs = false;
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
    MeshBuilder& builder() { return m_builder; }

private:
    bool addMesh(const SceneMesh& mesh, int node, const glm::mat4& nodeToWorld)
    {
        m_found.triangles = m_found.triangles || !mesh.triangles.empty();
        if (mesh.triangles.empty() || mesh.uvs.empty())
            return true;
        m_found.uvs = true;
        const glm::mat4 toWorld = m_skeleton.meshToWorld(mesh, nodeToWorld);
        const std::vector<model::BoneWeights> bones = m_skeleton.weightsOf(mesh, node, toWorld);
        const glm::mat3 turned(toWorld);
        // A mirrored node turns triangles inside out.
        const bool mirrored = glm::determinant(turned) < 0.0F;
        const glm::mat3 forNormals = glm::transpose(glm::inverse(turned));
        for (const glm::uvec3& indices : mesh.triangles) {
            std::array<Corner, 3> triangle;
            for (int corner = 0; corner < 3; ++corner) {
                const std::uint32_t vertex = indices[mirrored ? 2 - corner : corner];
                Corner& own = triangle.at(static_cast<std::size_t>(corner));
                own.position = glm::vec3(toWorld * glm::vec4(mesh.positions[vertex], 1.0F));
                own.normal = forNormals * mesh.normals[vertex];
                own.uv = mesh.uvs[vertex];
                if (!bones.empty())
                    own.bones = bones[vertex];
            }
            m_builder.add(triangle);
            if (m_builder.vertexCount() > sim::kMostVertices || m_builder.triangleCount() > sim::kMostTriangles)
                return false;
        }
        return true;
    }

    const ForeignScene& m_scene;
    SceneSkeleton& m_skeleton;
    MeshBuilder m_builder;
    Found m_found;
};

} // namespace

tl::expected<model::RiggedMesh, wire::Refusal> flattened(const ForeignScene& scene)
{
    SceneSkeleton skeleton(scene);
    SceneFlattener flattener(scene, skeleton);
    if (!flattener.addNode(0, glm::mat4(1.0F), 0))
        return tl::unexpected(wire::Reason::TooLarge);
    if (!flattener.found().triangles)
        return tl::unexpected(wire::Reason::NoTriangles);
    if (!flattener.found().uvs)
        return tl::unexpected(wire::Reason::NoUvs);
    model::RiggedMesh mesh = flattener.builder().take();
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
