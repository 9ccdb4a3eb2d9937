// The joints of a scene, and what its meshes' vertices follow.
#pragma once

#include "app/importer/foreign_scene.h"
#include "model/heads/head_skeleton.h"

#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace hairpaint::importer {

/// Joints are the nodes that meshes name as their bones, and all others under the same top node, but those that only
/// hold meshes; where these are too many, only what bones hang from. Where a mesh was bound tells where its joints are;
/// others follow their parents. Keeps the scene by reference.
class SceneSkeleton
{
public:
    explicit SceneSkeleton(const ForeignScene& scene);

    /// The matrix that places a mesh's vertices in the scene. `toWorld`: that of its node.
    [[nodiscard]] glm::mat4 meshToWorld(const SceneMesh& mesh, const glm::mat4& toWorld) const;
    /// Weights by the mesh's vertex; empty where the scene has no joints. Remembers the poses in which its joints were
    /// bound. `meshToWorld`: as meshToWorld() gives it.
    [[nodiscard]] std::vector<model::BoneWeights> weightsOf(const SceneMesh& mesh, int node,
                                                            const glm::mat4& meshToWorld);
    /// The joints, without weights; none where there are too many or their poses can't be told. Call it after
    /// weightsOf() of all meshes. A joint whose node names a bone has the bone's name.
    [[nodiscard]] model::HeadSkeleton joints() const;

private:
    struct Joint
    {
        int node = 0;
        int parent = -1;
        glm::mat4 toWorld{1.0F};          ///< The pose in the scene.
        std::optional<glm::mat4> bound{}; ///< The pose in which the meshes were bound.
    };

    void findBones();
    void findJoints();
    int addJoint(int node, const glm::mat4& toWorld, int parent); ///< Returns its index.
    /// Adds the joints of the node and of all nodes below it.
    void addJoints(int node, const glm::mat4& parentToWorld, int parent, unsigned depth);
    [[nodiscard]] bool isJoint(int node) const;
    [[nodiscard]] const SceneNode& at(int node) const { return m_scene.nodes[static_cast<std::size_t>(node)]; }
    /// Index of the node's joint; -1 where it has none.
    [[nodiscard]] int indexOf(int node) const;
    /// Index of the nearest joint at the node or above it; the first joint where there is none.
    [[nodiscard]] int jointAbove(int node) const;

    const ForeignScene& m_scene;
    bool m_onlyNeeded = false;
    std::unordered_set<int> m_needed; ///< The nodes of bones, and all nodes above them.
    std::vector<int> m_tops;          ///< The nodes of m_needed that lie directly below the scene's root.
    std::unordered_map<int, int> m_byNode;
    std::vector<Joint> m_joints;
};

} // namespace hairpaint::importer
