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

    /// Where a mesh's vertices stand. `toWorld`: its node's.
    [[nodiscard]] glm::mat4 meshToWorld(const SceneMesh& mesh, const glm::mat4& toWorld) const;
    /// By the mesh's vertex; empty where the scene has no joints. Remembers where its joints were bound; `meshToWorld`:
    /// as above.
    [[nodiscard]] std::vector<model::BoneWeights> weightsOf(const SceneMesh& mesh, int node,
                                                            const glm::mat4& meshToWorld);
    /// Without weights; none where there are too many joints, or where they stand can't be told. Once all weights are
    /// asked for. A joint whose node names a bone bears the bone's name.
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
    /// Of the node and of all below it.
    void addJoints(int node, const glm::mat4& parentToWorld, int parent, unsigned depth);
    [[nodiscard]] bool isJoint(int node) const;
    [[nodiscard]] const SceneNode& at(int node) const { return m_scene.nodes[static_cast<std::size_t>(node)]; }
    /// Of a bone's node; -1 where it is none.
    [[nodiscard]] int indexOf(int node) const;
    /// The nearest at the node or above it; the first where there is none.
    [[nodiscard]] int jointAbove(int node) const;

    const ForeignScene& m_scene;
    bool m_onlyNeeded = false;
    std::unordered_set<int> m_needed; ///< Bones' nodes, and those above them.
    std::vector<int> m_tops;          ///< Of these, those below the scene's root.
    std::unordered_map<int, int> m_byNode;
    std::vector<Joint> m_joints;
};

} // namespace hairpaint::importer
