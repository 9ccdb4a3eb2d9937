// Where the face looks follows from where left and right are; arms that hang are lifted with the skin.
#include "model/cards/avatar_body.h"

#include "model/exporting/unit_vectors.h"
#include "sim/skin/skin.h"

#include <cmath>
#include <tuple>
#include <utility>

namespace hairpaint::model {

namespace {

/// The quarter turn that has the left arm at +x. It is exact, so that a body that stands right stays bit for bit.
glm::quat turnToFront(const Avatar& avatar, const std::vector<JointPose>& poses)
{
    const auto at = [&](HumanBone bone) { return poses[static_cast<std::size_t>(avatar.bones[bone])].position; };
    const glm::vec3 left = at(HumanBone::LeftUpperArm) - at(HumanBone::RightUpperArm) + at(HumanBone::LeftUpperLeg) -
                           at(HumanBone::RightUpperLeg);
    const float half = std::sqrt(0.5F);
    if (std::abs(left.x) >= std::abs(left.z))
        return left.x >= 0.0F ? glm::quat(1.0F, 0.0F, 0.0F, 0.0F) : glm::quat(0.0F, 0.0F, 1.0F, 0.0F);
    return glm::quat(half, 0.0F, left.z > 0.0F ? half : -half, 0.0F);
}

/// The shortest turn from one direction to another; none where they are nearly the same, or opposite.
glm::quat turnBetween(const glm::vec3& from, const glm::vec3& to)
{
    constexpr float kSame = 0.9986F; // 3 degrees.
    const float length = glm::length(from);
    const float cosine = length > 0.0F ? glm::dot(from, to) / length : 1.0F;
    if (cosine > kSame || cosine < -kSame)
        return {1.0F, 0.0F, 0.0F, 0.0F};
    return glm::normalize(glm::quat(1.0F + cosine, glm::cross(from / length, to)));
}

/// A joint and all that hang from it.
void turnAbout(const HeadSkeleton& skeleton, int joint, const glm::quat& turn, std::vector<JointPose>& poses)
{
    const auto first = static_cast<std::size_t>(joint);
    const glm::vec3 pivot = poses[first].position;
    std::vector<bool> isBelow(poses.size());
    for (std::size_t i = first; i < poses.size(); ++i) { // Parents come before their children.
        const int parent = skeleton.joints[i].parent;
        isBelow[i] = i == first || (parent >= 0 && isBelow[static_cast<std::size_t>(parent)]);
        if (!isBelow[i])
            continue;
        poses[i] = {.position = pivot + turn * (poses[i].position - pivot),
                    .rotation = glm::normalize(turn * poses[i].rotation)};
    }
}

void holdArmsOut(const Avatar& avatar, std::vector<JointPose>& poses)
{
    using enum HumanBone;
    constexpr glm::vec3 kLeft(1.0F, 0.0F, 0.0F);
    for (const auto& [upper, lower, hand, out] : {std::tuple{LeftUpperArm, LeftLowerArm, LeftHand, kLeft},
                                                  std::tuple{RightUpperArm, RightLowerArm, RightHand, -kLeft}})
        for (const auto& [from, to] : {std::pair{upper, lower}, std::pair{lower, hand}}) {
            const int joint = avatar.bones[from];
            const glm::vec3 along = poses[static_cast<std::size_t>(avatar.bones[to])].position -
                                    poses[static_cast<std::size_t>(joint)].position;
            turnAbout(avatar.skeleton, joint, turnBetween(along, out), poses);
        }
}

} // namespace

AvatarBody avatarBody(const Avatar& avatar)
{
    std::vector<JointPose> bound = posesOf(avatar.skeleton);
    AvatarBody body{.turn = turnToFront(avatar, bound), .poses = {}, .mesh = {}};
    for (JointPose& pose : bound)
        pose = {.position = body.turn * pose.position, .rotation = glm::normalize(body.turn * pose.rotation)};
    body.poses = bound;
    holdArmsOut(avatar, body.poses);

    bool isMoved = false;
    std::vector<JointPose> moved; // From where a joint was bound.
    moved.reserve(bound.size());
    for (std::size_t i = 0; i < bound.size(); ++i) {
        const JointPose& pose = body.poses[i];
        isMoved = isMoved || pose.position != bound[i].position || pose.rotation != bound[i].rotation;
        const glm::quat turn = glm::normalize(pose.rotation * glm::conjugate(bound[i].rotation));
        moved.push_back({.position = pose.position - turn * bound[i].position, .rotation = turn});
    }
    const auto posed = [&](const sim::HeadMesh& mesh, const std::vector<BoneWeights>& weights) {
        PosedMesh made = plainHead(mesh);
        for (std::size_t i = 0; i < made.vertices.size(); ++i) {
            HeadVertexOut& vertex = made.vertices[i];
            const glm::vec3 position = body.turn * vertex.position;
            const glm::vec3 normal = body.turn * vertex.normal;
            vertex.position = position;
            vertex.normal = normal;
            if (!isMoved || i >= weights.size())
                continue;
            const BoneWeights& bones = weights[i];
            glm::vec3 blended(0.0F);
            glm::vec3 blendedNormal(0.0F);
            for (int b = 0; b < 4; ++b) {
                const JointPose& by = moved[bones.joints.at(static_cast<std::size_t>(b))];
                blended += bones.weights[b] * (by.position + by.rotation * position);
                blendedNormal += bones.weights[b] * (by.rotation * normal);
            }
            vertex.position = blended;
            vertex.normal = unitOr(blendedNormal, normal);
        }
        return made;
    };
    body.mesh = posed(avatar.skin->mesh(), avatar.skeleton.weights);
    for (std::size_t i = 0; i < avatar.parts.size(); ++i)
        body.parts.push_back(posed(*avatar.parts[i].mesh, avatar.partWeights[i]));
    return body;
}

} // namespace hairpaint::model
