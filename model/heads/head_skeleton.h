// The joints that a head's mesh came with, and what each of its vertices follows.
// Lengths: those of the mesh's positions; before scale and axis in files and messages, Hd once they are applied.
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hairpaint::model {

/// The joints that move a vertex, by index, with weights that sum to 1. Unused entries have joint 0 and weight 0.
struct BoneWeights
{
    std::array<std::uint16_t, 4> joints{};
    glm::vec4 weights{1.0F, 0.0F, 0.0F, 0.0F};
    friend bool operator==(const BoneWeights&, const BoneWeights&) = default;
};
static_assert(sizeof(BoneWeights) == 24);

/// A joint at rest, in the pose in which the mesh was bound. Joints have no scale: it does not change what they move.
struct HeadJoint
{
    std::string name;               ///< UTF-8, see isJointName.
    int parent = -1;                ///< An earlier joint; none for the first alone.
    glm::vec3 translation{0.0F};    ///< From the parent's origin, in its frame.
    glm::quat rotation{1, 0, 0, 0}; ///< From the joint's frame to the parent's; of unit length.
    friend bool operator==(const HeadJoint&, const HeadJoint&) = default;
};

struct HeadSkeleton
{
    static constexpr std::size_t kMostJoints = 1024;
    static constexpr std::size_t kLongestName = 64; ///< Bytes.

    std::vector<HeadJoint> joints;    ///< The first is the only one without a parent; none where there is no skeleton.
    std::vector<BoneWeights> weights; ///< One a vertex.
    [[nodiscard]] bool empty() const { return joints.empty(); }
    friend bool operator==(const HeadSkeleton&, const HeadSkeleton&) = default;
};

/// A joint's position and frame, seen from the mesh's origin.
struct JointPose
{
    glm::vec3 position{0.0F};
    glm::quat rotation{1, 0, 0, 0};
};

/// Whether `name` has at most HeadSkeleton::kLongestName bytes, is valid UTF-8 and has no control characters.
[[nodiscard]] bool isJointName(std::string_view name);
/// A foreign name cut to the allowed length, with what isJointName() forbids replaced.
[[nodiscard]] std::string jointNameOf(std::string_view foreign);

/// Whether the skeleton is empty, or keeps the limits above for a mesh with so many vertices.
[[nodiscard]] bool withinLimits(const HeadSkeleton& skeleton, std::size_t vertices);

/// The pose of each joint, by its index.
[[nodiscard]] std::vector<JointPose> posesOf(const HeadSkeleton& skeleton);
/// Sets the joints' translations and rotations so that posesOf() gives `poses`.
void setPoses(HeadSkeleton& skeleton, const std::vector<JointPose>& poses);
/// The matrix from the space that `pose` is given in to the joint's own frame.
[[nodiscard]] glm::mat4 inverseBind(const JointPose& pose);

} // namespace hairpaint::model
