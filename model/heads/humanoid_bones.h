// Which joints of a skeleton are the bones of a human body, by the names and order of VRM 1.0 (VRM Consortium,
// VRMC_vrm-1.0, "humanoid").
#pragma once

#include "model/heads/head_skeleton.h"
#include "model/values/sentences.h"

#include <array>
#include <cstdint>
#include <span>

namespace hairpaint::model {

enum class HumanBone : std::uint8_t
{
    Hips,
    Spine,
    Chest,
    UpperChest,
    Neck,
    Head,
    Jaw,
    LeftEye,
    LeftUpperLeg,
    LeftLowerLeg,
    LeftFoot,
    LeftToes,
    LeftShoulder,
    LeftUpperArm,
    LeftLowerArm,
    LeftHand,
    LeftThumbMetacarpal,
    LeftThumbProximal,
    LeftThumbDistal,
    LeftIndexProximal,
    LeftIndexIntermediate,
    LeftIndexDistal,
    LeftMiddleProximal,
    LeftMiddleIntermediate,
    LeftMiddleDistal,
    LeftRingProximal,
    LeftRingIntermediate,
    LeftRingDistal,
    LeftLittleProximal,
    LeftLittleIntermediate,
    LeftLittleDistal,
    RightEye, ///< From here on as on the left.
    RightUpperLeg,
    RightLowerLeg,
    RightFoot,
    RightToes,
    RightShoulder,
    RightUpperArm,
    RightLowerArm,
    RightHand,
    RightThumbMetacarpal,
    RightThumbProximal,
    RightThumbDistal,
    RightIndexProximal,
    RightIndexIntermediate,
    RightIndexDistal,
    RightMiddleProximal,
    RightMiddleIntermediate,
    RightMiddleDistal,
    RightRingProximal,
    RightRingIntermediate,
    RightRingDistal,
    RightLittleProximal,
    RightLittleIntermediate,
    RightLittleDistal,
    Count
};

inline constexpr std::size_t kHumanBoneCount = static_cast<std::size_t>(HumanBone::Count);

struct HumanBoneSpec
{
    const char* id;   ///< "leftUpperArm", as VRM has it.
    HumanBone parent; ///< The nearest above it that may be there; of the hips, themselves.
    bool required;
};

[[nodiscard]] const HumanBoneSpec& humanBoneSpec(HumanBone bone);

/// Indices of joints; -1 for a bone that is not there.
struct HumanoidBones
{
    std::array<int, kHumanBoneCount> joints{};
    HumanoidBones() { joints.fill(-1); }
    [[nodiscard]] int operator[](HumanBone bone) const { return joints[static_cast<std::size_t>(bone)]; }
    [[nodiscard]] int& operator[](HumanBone bone) { return joints[static_cast<std::size_t>(bone)]; }
};

/// All that VRM requires, each below the one that is its parent there. Where some can't be told from the joints' names
/// and parents, a clause that names them, with what to do about it.
[[nodiscard]] Checked<HumanoidBones> humanoidBones(std::span<const HeadJoint> joints);

} // namespace hairpaint::model
