// Joints, their bind poses, and the four heaviest weights of each vertex.
#include "app/importer/scene_skeleton.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace hairpaint::importer {

namespace {

constexpr unsigned kDeepestJoint = 256;

/// Assimp's own, between a joint of an FBX and the next.
bool isPivot(const aiNode& node)
{
    return std::string_view(node.mName.C_Str()).find("_$AssimpFbx$") != std::string_view::npos;
}

bool isFinite(const aiMatrix4x4& matrix)
{
    const float* values = &matrix.a1;
    return std::all_of(values, values + 16, [](float value) { return std::isfinite(value); });
}

/// The inverse; none where there is no such.
std::optional<aiMatrix4x4> inverseOf(aiMatrix4x4 matrix)
{
    const float determinant = matrix.Determinant();
    if (!isFinite(matrix) || !std::isfinite(determinant) || determinant == 0.0F)
        return std::nullopt;
    matrix.Inverse();
    if (!isFinite(matrix))
        return std::nullopt;
    return matrix;
}

/// Without scale and shear: x along the first axis, y as near to the second as may be. No frame where an axis has no
/// length.
glm::quat rotationOf(const aiMatrix4x4& matrix)
{
    constexpr float kShort = 1e-12F;
    const glm::vec3 first(matrix.a1, matrix.b1, matrix.c1);
    const glm::vec3 second(matrix.a2, matrix.b2, matrix.c2);
    const float firstLength = glm::length(first);
    const float secondLength = glm::length(second);
    if (!(firstLength > kShort) || !(secondLength > kShort))
        return {1.0F, 0.0F, 0.0F, 0.0F};
    const glm::vec3 x = first / firstLength;
    const glm::vec3 across = second / secondLength - glm::dot(x, second / secondLength) * x;
    const float acrossLength = glm::length(across);
    if (!(acrossLength > 1e-4F))
        return {1.0F, 0.0F, 0.0F, 0.0F};
    const glm::vec3 y = across / acrossLength;
    return glm::normalize(glm::quat_cast(glm::mat3(x, y, glm::cross(x, y))));
}

/// A vertex's heaviest, from the heaviest on.
struct Heaviest
{
    std::array<int, 4> joints{};
    std::array<float, 4> weights{};

    void add(int joint, float weight)
    {
        if (!(weight > 0.0F) || !std::isfinite(weight))
            return;
        for (std::size_t i = 0; i < weights.size(); ++i)
            if (weight > weights.at(i)) {
                std::swap(weight, weights.at(i));
                std::swap(joint, joints.at(i));
            }
    }
    /// `otherwise`: what it follows where nothing weighs on it.
    [[nodiscard]] model::BoneWeights normalized(int otherwise) const
    {
        model::BoneWeights bones;
        const float sum = weights[0] + weights[1] + weights[2] + weights[3];
        if (!(sum > 0.0F) || !std::isfinite(sum)) {
            bones.joints[0] = static_cast<std::uint16_t>(otherwise);
            return bones;
        }
        float others = 0.0F;
        for (std::size_t i = 1; i < weights.size(); ++i) {
            const float part = weights.at(i) / sum;
            bones.joints.at(i) = static_cast<std::uint16_t>(part > 0.0F ? joints.at(i) : 0);
            bones.weights[static_cast<int>(i)] = part;
            others += part;
        }
        bones.joints[0] = static_cast<std::uint16_t>(joints[0]);
        bones.weights[0] = 1.0F - others;
        return bones;
    }
};

} // namespace

SceneSkeleton::SceneSkeleton(const aiScene& scene, bool boundByJoints) : m_boundByJoints(boundByJoints)
{
    findBones(scene);
    findJoints(*scene.mRootNode);
    if (m_joints.size() <= model::HeadSkeleton::kMostJoints)
        return;
    m_onlyNeeded = true;
    m_joints.clear();
    m_byName.clear();
    m_byNode.clear();
    findJoints(*scene.mRootNode);
}

void SceneSkeleton::findBones(const aiScene& scene)
{
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
        const aiMesh& mesh = *scene.mMeshes[i];
        for (unsigned b = 0; b < mesh.mNumBones; ++b) {
            const aiNode* node = scene.mRootNode->FindNode(mesh.mBones[b]->mName);
            for (unsigned depth = 0; node != nullptr && depth <= kDeepestJoint; node = node->mParent, ++depth) {
                if (node == scene.mRootNode && depth > 0)
                    break; // It is one only where it is named itself.
                if (!m_needed.insert(node).second)
                    break;
                if (node->mParent == scene.mRootNode)
                    m_tops.push_back(node);
            }
        }
    }
}

void SceneSkeleton::findJoints(const aiNode& root)
{
    const bool isRootJoint = m_needed.contains(&root) || m_tops.size() > 1; // One stands above all.
    if (isRootJoint)
        addJoint(root, root.mTransformation, -1);
    for (const aiNode* top : m_tops)
        addJoints(*top, root.mTransformation, isRootJoint ? 0 : -1, 0);
}

int SceneSkeleton::addJoint(const aiNode& node, const aiMatrix4x4& toWorld, int parent)
{
    const auto own = static_cast<int>(m_joints.size());
    m_joints.push_back({.node = &node, .parent = parent, .toWorld = toWorld});
    m_byNode.emplace(&node, own);
    m_byName.try_emplace(node.mName.C_Str(), own);
    return own;
}

bool SceneSkeleton::isJoint(const aiNode& node) const
{
    if (isPivot(node))
        return false;
    return (node.mNumMeshes == 0 && !m_onlyNeeded) || m_needed.contains(&node);
}

void SceneSkeleton::addJoints(const aiNode& node, const aiMatrix4x4& parentToWorld, int parent, unsigned depth)
{
    if (depth > kDeepestJoint || m_joints.size() > model::HeadSkeleton::kMostJoints)
        return;
    const aiMatrix4x4 toWorld = parentToWorld * node.mTransformation;
    // A pivot above all joints would leave several without a parent.
    const int own = isJoint(node) || parent < 0 ? addJoint(node, toWorld, parent) : parent;
    for (unsigned i = 0; i < node.mNumChildren; ++i)
        addJoints(*node.mChildren[i], toWorld, own, depth + 1);
}

int SceneSkeleton::indexOf(const aiString& name) const
{
    const auto found = m_byName.find(name.C_Str());
    return found == m_byName.end() ? -1 : found->second;
}

int SceneSkeleton::jointAbove(const aiNode& node) const
{
    for (const aiNode* at = &node; at != nullptr; at = at->mParent)
        if (const auto found = m_byNode.find(at); found != m_byNode.end())
            return found->second;
    return 0;
}

aiMatrix4x4 SceneSkeleton::meshToWorld(const aiMesh& mesh, const aiMatrix4x4& toWorld) const
{
    if (!m_boundByJoints)
        return toWorld;
    const aiBone* highest = nullptr;
    int first = static_cast<int>(m_joints.size());
    for (unsigned b = 0; b < mesh.mNumBones; ++b) {
        const int joint = indexOf(mesh.mBones[b]->mName);
        if (joint >= 0 && joint < first) { // Parents come before their children.
            first = joint;
            highest = mesh.mBones[b];
        }
    }
    return highest == nullptr ? toWorld : m_joints[static_cast<std::size_t>(first)].toWorld * highest->mOffsetMatrix;
}

std::vector<model::BoneWeights> SceneSkeleton::weightsOf(const aiMesh& mesh, const aiNode& node,
                                                         const aiMatrix4x4& meshToWorld)
{
    if (m_joints.empty())
        return {};
    std::vector<Heaviest> heaviest(mesh.mNumVertices);
    for (unsigned b = 0; b < mesh.mNumBones; ++b) {
        const aiBone& bone = *mesh.mBones[b];
        const int joint = indexOf(bone.mName);
        if (joint < 0)
            continue;
        std::optional<aiMatrix4x4>& bound = m_joints[static_cast<std::size_t>(joint)].bound;
        if (const std::optional<aiMatrix4x4> back = inverseOf(bone.mOffsetMatrix); back && !bound)
            bound = meshToWorld * *back;
        for (unsigned i = 0; i < bone.mNumWeights; ++i)
            if (bone.mWeights[i].mVertexId < mesh.mNumVertices)
                heaviest[bone.mWeights[i].mVertexId].add(joint, bone.mWeights[i].mWeight);
    }
    const int otherwise = jointAbove(node);
    std::vector<model::BoneWeights> weights;
    weights.reserve(heaviest.size());
    for (const Heaviest& own : heaviest)
        weights.push_back(own.normalized(otherwise));
    return weights;
}

model::HeadSkeleton SceneSkeleton::joints(const BoneNames& bones) const
{
    if (m_joints.size() > model::HeadSkeleton::kMostJoints)
        return {};
    model::HeadSkeleton skeleton;
    std::vector<aiMatrix4x4> toWorld;
    std::vector<model::JointPose> poses;
    for (const Joint& joint : m_joints) {
        aiMatrix4x4 own = joint.toWorld;
        if (joint.bound) {
            own = *joint.bound;
        } else if (joint.parent >= 0) {
            const auto parent = static_cast<std::size_t>(joint.parent);
            if (const std::optional<aiMatrix4x4> back = inverseOf(m_joints[parent].toWorld))
                own = toWorld[parent] * (*back * joint.toWorld);
        }
        toWorld.push_back(own);
        poses.push_back({.position = {own.a4, own.b4, own.c4}, .rotation = rotationOf(own)});
        const std::string_view name(joint.node->mName.C_Str(), joint.node->mName.length);
        const auto bone = bones.find(std::string(name));
        skeleton.joints.push_back(
            {.name = model::jointNameOf(bone == bones.end() ? name : bone->second), .parent = joint.parent});
    }
    setPoses(skeleton, poses);
    return skeleton;
}

} // namespace hairpaint::importer
