// The joints of a scene, and what its meshes' vertices follow.
#pragma once

#include "app/importer/vrm_bones.h"
#include "model/heads/head_skeleton.h"

#include <assimp/scene.h>

#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace hairpaint::importer {

/// Joints are the nodes that meshes name as their bones, and all others under the same top node, but those that only
/// hold meshes; where these are too many, only what bones hang from. Where a mesh was bound tells where its joints are;
/// others follow their parents.
class SceneSkeleton
{
public:
    /// `boundByJoints`: skinned meshes stand where their joints put them, whatever their own nodes say (as in glTF).
    SceneSkeleton(const aiScene& scene, bool boundByJoints);

    /// Where a mesh's vertices stand. `toWorld`: its node's.
    [[nodiscard]] aiMatrix4x4 meshToWorld(const aiMesh& mesh, const aiMatrix4x4& toWorld) const;
    /// By the mesh's vertex; empty where the scene has no joints. Remembers where its joints were bound; `meshToWorld`:
    /// as above.
    [[nodiscard]] std::vector<model::BoneWeights> weightsOf(const aiMesh& mesh, const aiNode& node,
                                                            const aiMatrix4x4& meshToWorld);
    /// Without weights; none where there are too many joints, or where they stand can't be told. Once all weights are
    /// asked for. What `bones` tell of bears the bone's name.
    [[nodiscard]] model::HeadSkeleton joints(const BoneNames& bones) const;

private:
    struct Joint
    {
        const aiNode* node = nullptr;
        int parent = -1;
        aiMatrix4x4 toWorld{};              ///< The pose in the scene.
        std::optional<aiMatrix4x4> bound{}; ///< The pose in which the meshes were bound.
    };

    void findBones(const aiScene& scene);
    void findJoints(const aiNode& root);
    int addJoint(const aiNode& node, const aiMatrix4x4& toWorld, int parent); ///< Returns its index.
    /// Of the node and of all below it.
    void addJoints(const aiNode& node, const aiMatrix4x4& parentToWorld, int parent, unsigned depth);
    [[nodiscard]] bool isJoint(const aiNode& node) const;
    /// Of a name that a mesh's bone has; -1 where there is none.
    [[nodiscard]] int indexOf(const aiString& name) const;
    /// The nearest at the node or above it; the first where there is none.
    [[nodiscard]] int jointAbove(const aiNode& node) const;

    bool m_boundByJoints;
    bool m_onlyNeeded = false;
    std::unordered_set<const aiNode*> m_needed; ///< Bones' nodes, and those above them.
    std::vector<const aiNode*> m_tops;          ///< Of these, those below the scene's root.
    std::unordered_map<std::string, int> m_byName;
    std::unordered_map<const aiNode*, int> m_byNode;
    std::vector<Joint> m_joints;
};

} // namespace hairpaint::importer
