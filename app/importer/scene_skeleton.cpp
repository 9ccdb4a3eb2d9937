// Joints, their bind poses, and the four heaviest weights of each vertex.
#include "app/importer/scene_skeleton.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace hairpaint::importer {

namespace {

constexpr unsigned kDeepestJoint = 256;
constexpr int kRoot = 0; ///< Index of the root among a scene's nodes.

/// Assimp's own, between a joint of an FBX and the next.
bool isPivot(const SceneNode& node)
{
    return node.name.find("_$AssimpFbx$") != std::string::npos;
}

bool isFinite(const glm::mat4& matrix)
{
    const float* values = &matrix[0][0];
    return std::all_of(values, values + 16, [](float value) { return std::isfinite(value); });
}

/// The inverse; none where there is no such.
std::optional<glm::mat4> inverseOf(const glm::mat4& matrix)
{
    const float determinant = glm::determinant(matrix);
    if (!isFinite(matrix) || !std::isfinite(determinant) || determinant == 0.0F)
        return std::nullopt;
    const glm::mat4 inverse = glm::inverse(matrix);
    if (!isFinite(inverse))
        return std::nullopt;
    return inverse;
}

/// Without scale and shear: x along the first axis, y as near to the second as may be. No frame where an axis has no
/// length.
glm::quat rotationOf(const glm::mat4& matrix)
{
    constexpr float kShort = 1e-12F;
    const glm::vec3 first(matrix[0]);
    const glm::vec3 second(matrix[1]);
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

SceneSkeleton::SceneSkeleton(const ForeignScene& scene) : m_scene(scene)
{
    findBones();
    findJoints();
    if (m_joints.size() <= model::HeadSkeleton::kMostJoints)
        return;
    m_onlyNeeded = true;
    m_joints.clear();
    m_byNode.clear();
    findJoints();
}

void SceneSkeleton::findBones()
{
    for (const SceneMesh& mesh : m_scene.meshes)
        for (const SceneBone& bone : mesh.bones) {
            int node = bone.node;
            for (unsigned depth = 0; node >= 0 && depth <= kDeepestJoint; node = at(node).parent, ++depth) {
                if (node == kRoot && depth > 0)
                    break; // It is one only where it is named itself.
                if (!m_needed.insert(node).second)
                    break;
                if (at(node).parent == kRoot)
                    m_tops.push_back(node);
            }
        }
}

void SceneSkeleton::findJoints()
{
    const bool isRootJoint = m_needed.contains(kRoot) || m_tops.size() > 1; // One stands above all.
    if (isRootJoint)
        addJoint(kRoot, at(kRoot).toParent, -1);
    for (const int top : m_tops)
        addJoints(top, at(kRoot).toParent, isRootJoint ? 0 : -1, 0);
}

int SceneSkeleton::addJoint(int node, const glm::mat4& toWorld, int parent)
{
    const auto own = static_cast<int>(m_joints.size());
    m_joints.push_back({.node = node, .parent = parent, .toWorld = toWorld});
    m_byNode.emplace(node, own);
    return own;
}

bool SceneSkeleton::isJoint(int node) const
{
    if (isPivot(at(node)))
        return false;
    return (at(node).meshes.empty() && !m_onlyNeeded) || m_needed.contains(node);
}

void SceneSkeleton::addJoints(int node, const glm::mat4& parentToWorld, int parent, unsigned depth)
{
    if (depth > kDeepestJoint || m_joints.size() > model::HeadSkeleton::kMostJoints)
        return;
    const glm::mat4 toWorld = parentToWorld * at(node).toParent;
    // A pivot above all joints would leave several without a parent.
    const int own = isJoint(node) || parent < 0 ? addJoint(node, toWorld, parent) : parent;
    for (const int child : at(node).children)
        addJoints(child, toWorld, own, depth + 1);
}

int SceneSkeleton::indexOf(int node) const
{
    const auto found = m_byNode.find(node);
    return found == m_byNode.end() ? -1 : found->second;
}

int SceneSkeleton::jointAbove(int node) const
{
    for (int above = node; above >= 0; above = at(above).parent)
        if (const int joint = indexOf(above); joint >= 0)
            return joint;
    return 0;
}

glm::mat4 SceneSkeleton::meshToWorld(const SceneMesh& mesh, const glm::mat4& toWorld) const
{
    if (!m_scene.boundByJoints)
        return toWorld;
    const SceneBone* highest = nullptr;
    int first = static_cast<int>(m_joints.size());
    for (const SceneBone& bone : mesh.bones) {
        const int joint = indexOf(bone.node);
        if (joint >= 0 && joint < first) { // Parents come before their children.
            first = joint;
            highest = &bone;
        }
    }
    return highest == nullptr ? toWorld : m_joints[static_cast<std::size_t>(first)].toWorld * highest->meshToNode;
}

std::vector<model::BoneWeights> SceneSkeleton::weightsOf(const SceneMesh& mesh, int node, const glm::mat4& meshToWorld)
{
    if (m_joints.empty())
        return {};
    std::vector<int> joints;
    for (const SceneBone& bone : mesh.bones) {
        joints.push_back(indexOf(bone.node));
        if (joints.back() < 0)
            continue;
        std::optional<glm::mat4>& bound = m_joints[static_cast<std::size_t>(joints.back())].bound;
        if (const std::optional<glm::mat4> back = inverseOf(bone.meshToNode); back && !bound)
            bound = meshToWorld * *back;
    }
    std::vector<Heaviest> heaviest(mesh.positions.size());
    for (const VertexWeight& weight : mesh.weights)
        if (joints[weight.bone] >= 0)
            heaviest[weight.vertex].add(joints[weight.bone], weight.weight);
    const int otherwise = jointAbove(node);
    std::vector<model::BoneWeights> weights;
    weights.reserve(heaviest.size());
    for (const Heaviest& own : heaviest)
        weights.push_back(own.normalized(otherwise));
    return weights;
}

model::HeadSkeleton SceneSkeleton::joints() const
{
    if (m_joints.size() > model::HeadSkeleton::kMostJoints)
        return {};
    model::HeadSkeleton skeleton;
    std::vector<glm::mat4> toWorld;
    std::vector<model::JointPose> poses;
    for (const Joint& joint : m_joints) {
        glm::mat4 own = joint.toWorld;
        if (joint.bound) {
            own = *joint.bound;
        } else if (joint.parent >= 0) {
            const auto parent = static_cast<std::size_t>(joint.parent);
            if (const std::optional<glm::mat4> back = inverseOf(m_joints[parent].toWorld))
                own = toWorld[parent] * (*back * joint.toWorld);
        }
        toWorld.push_back(own);
        poses.push_back({.position = glm::vec3(own[3]), .rotation = rotationOf(own)});
        const SceneNode& node = at(joint.node);
        skeleton.joints.push_back(
            {.name = model::jointNameOf(node.boneName.empty() ? node.name : node.boneName), .parent = joint.parent});
    }
    setPoses(skeleton, poses);
    return skeleton;
}

} // namespace hairpaint::importer
