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

/// What moves a vertex: joints of one skin by their indices. Weights sum to 1; joint 0 stands where there is no more.
struct BoneWeights
{
    std::array<std::uint16_t, 4> joints{};
    glm::vec4 weights{1.0F, 0.0F, 0.0F, 0.0F};
    friend bool operator==(const BoneWeights&, const BoneWeights&) = default;
};
static_assert(sizeof(BoneWeights) == 24);

/// At rest, where the mesh is as it was bound. Without scale: what a joint moves is the same under any.
struct HeadJoint
{
    std::string name;               ///< UTF-8, see isJointName.
    int parent = -1;                ///< An earlier joint; none for the first alone.
    glm::vec3 translation{0.0F};    ///< From the parent's origin, in its frame.
    glm::quat rotation{1, 0, 0, 0}; ///< Of unit length, likewise.
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

/// At most so long, valid UTF-8, no control characters.
[[nodiscard]] bool isJointName(std::string_view name);
/// As many bytes of a foreign name as may stay; what may not is replaced.
[[nodiscard]] std::string jointNameOf(std::string_view foreign);

/// No joints and no weights, or what the comments above promise, for a mesh of so many vertices.
[[nodiscard]] bool withinLimits(const HeadSkeleton& skeleton, std::size_t vertices);

/// By joint.
[[nodiscard]] std::vector<JointPose> posesOf(const HeadSkeleton& skeleton);
/// The joints' own translation and rotation, so that they come to stand there.
void setPoses(HeadSkeleton& skeleton, const std::vector<JointPose>& poses);
/// From the frame that the joint stands in to the joint's own.
[[nodiscard]] glm::mat4 inverseBind(const JointPose& pose);

} // namespace hairpaint::model
