// Limits of a skeleton, names of joints, and transforms from parent to child.
#include "model/heads/head_skeleton.h"

#include "sim/skin/head_limits.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::model {

namespace {

/// Bytes of the UTF-8 character that begins there (RFC 3629); 0 where none does.
std::size_t characterAt(std::string_view text, std::size_t at)
{
    const auto byte = [&](std::size_t i) -> unsigned {
        return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0U;
    };
    const unsigned first = byte(0);
    if (first < 0x80U)
        return 1;
    const std::size_t length = first >= 0xF0U ? 4 : first >= 0xE0U ? 3 : 2;
    if (first < 0xC2U || first > 0xF4U)
        return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xC0U) != 0x80U)
            return 0;
    // Longer than need be, halves of pairs, and beyond the last character.
    const bool isWrong = (first == 0xE0U && byte(1) < 0xA0U) || (first == 0xEDU && byte(1) > 0x9FU) ||
                         (first == 0xF0U && byte(1) < 0x90U) || (first == 0xF4U && byte(1) > 0x8FU);
    return isWrong ? 0 : length;
}

bool isControl(std::string_view character)
{
    constexpr char kDelete = 0x7F;
    if (character.size() == 1)
        return (character[0] >= 0 && character[0] < ' ') || character[0] == kDelete;
    return character.size() == 2 && character[0] == '\xC2' && static_cast<unsigned char>(character[1]) < 0xA0U;
}

bool isFitting(const HeadJoint& joint, std::size_t index)
{
    constexpr float kUnitTolerance = 1e-3F;
    const bool isParentEarlier =
        index == 0 ? joint.parent == -1 : joint.parent >= 0 && static_cast<std::size_t>(joint.parent) < index;
    // Comparisons are false for NaN.
    const auto isNear = [](float value) { return std::abs(value) <= sim::kFarthestPosition; };
    return isParentEarlier && isJointName(joint.name) && isNear(joint.translation.x) && isNear(joint.translation.y) &&
           isNear(joint.translation.z) && std::abs(glm::dot(joint.rotation, joint.rotation) - 1.0F) <= kUnitTolerance;
}

bool isFitting(const BoneWeights& bones, std::size_t joints)
{
    constexpr float kSumTolerance = 1e-3F;
    float sum = 0.0F;
    for (int i = 0; i < 4; ++i) {
        if (!(bones.weights[i] >= 0.0F))
            return false;
        sum += bones.weights[i];
    }
    return std::abs(sum - 1.0F) <= kSumTolerance &&
           std::ranges::all_of(bones.joints, [joints](std::size_t joint) { return joint < joints; });
}

} // namespace

bool isJointName(std::string_view name)
{
    if (name.size() > HeadSkeleton::kLongestName)
        return false;
    for (std::size_t at = 0; at < name.size();) {
        const std::size_t length = characterAt(name, at);
        if (length == 0 || isControl(name.substr(at, length)))
            return false;
        at += length;
    }
    return true;
}

std::string jointNameOf(std::string_view foreign)
{
    std::string name;
    for (std::size_t at = 0; at < foreign.size();) {
        const std::size_t length = characterAt(foreign, at);
        const std::string_view character = foreign.substr(at, std::max<std::size_t>(length, 1));
        at += character.size();
        const std::string_view kept = length == 0 || isControl(character) ? "_" : character;
        if (name.size() + kept.size() > HeadSkeleton::kLongestName)
            break;
        name += kept;
    }
    return name;
}

bool withinLimits(const HeadSkeleton& skeleton, std::size_t vertices)
{
    if (skeleton.empty())
        return skeleton.weights.empty();
    if (skeleton.joints.size() > HeadSkeleton::kMostJoints || skeleton.weights.size() != vertices)
        return false;
    for (std::size_t i = 0; i < skeleton.joints.size(); ++i)
        if (!isFitting(skeleton.joints[i], i))
            return false;
    return std::ranges::all_of(
        skeleton.weights, [&skeleton](const BoneWeights& bones) { return isFitting(bones, skeleton.joints.size()); });
}

std::vector<JointPose> posesOf(const HeadSkeleton& skeleton)
{
    std::vector<JointPose> poses;
    poses.reserve(skeleton.joints.size());
    for (const HeadJoint& joint : skeleton.joints) {
        const JointPose parent = joint.parent >= 0 ? poses[static_cast<std::size_t>(joint.parent)] : JointPose{};
        poses.push_back({.position = parent.position + parent.rotation * joint.translation,
                         .rotation = glm::normalize(parent.rotation * joint.rotation)});
    }
    return poses;
}

void setPoses(HeadSkeleton& skeleton, const std::vector<JointPose>& poses)
{
    for (std::size_t i = 0; i < skeleton.joints.size(); ++i) {
        HeadJoint& joint = skeleton.joints[i];
        const JointPose parent = joint.parent >= 0 ? poses[static_cast<std::size_t>(joint.parent)] : JointPose{};
        const glm::quat back = glm::conjugate(parent.rotation);
        joint.translation = back * (poses[i].position - parent.position);
        const glm::quat turn = glm::normalize(back * poses[i].rotation);
        // No part of a unit quaternion is above 1, which rounding may make of it.
        joint.rotation = {glm::clamp(turn.w, -1.0F, 1.0F), glm::clamp(turn.x, -1.0F, 1.0F),
                          glm::clamp(turn.y, -1.0F, 1.0F), glm::clamp(turn.z, -1.0F, 1.0F)};
    }
}

glm::mat4 inverseBind(const JointPose& pose)
{
    const glm::quat back = glm::conjugate(pose.rotation);
    glm::mat4 matrix = glm::mat4_cast(back);
    matrix[3] = glm::vec4(back * -pose.position, 1.0F);
    return matrix;
}

} // namespace hairpaint::model
