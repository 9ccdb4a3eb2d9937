// Poses and rigid motions, without functions that differ between machines.
#include "sim/motion/head_motion.h"

#include <cmath>

namespace hairpaint::sim {

namespace {

constexpr float kFurthestM = 0.15F; ///< Greatest distance of the head in a step; a faster head takes its hair along.
constexpr float kLeastHalfCosine = 0.9922F; ///< Cosine of half the greatest angle turned in a step, 0.25 rad.

glm::quat normalised(const glm::quat& q)
{
    return q * (1.0F / std::sqrt(glm::dot(q, q)));
}

RigidMotion rigid(const glm::mat3& rotation, glm::vec3 offset)
{
    RigidMotion motion;
    for (int row = 0; row < 3; ++row) {
        const auto r = static_cast<std::size_t>(row);
        for (int column = 0; column < 3; ++column)
            motion.rows[r][static_cast<std::size_t>(column)] = rotation[column][row];
        motion.offset[r] = offset[row];
    }
    motion.identity = rotation == glm::mat3(1.0F) && offset == glm::vec3(0.0F);
    return motion;
}

} // namespace

HeadPose mixPoses(const HeadPose& from, const HeadPose& to, float fraction)
{
    if (fraction <= 0.0F || from == to)
        return from;
    if (fraction >= 1.0F)
        return to;
    const glm::quat near = glm::dot(from.rotation, to.rotation) < 0.0F ? -to.rotation : to.rotation;
    HeadPose pose;
    pose.rotation = normalised(from.rotation * (1.0F - fraction) + near * fraction);
    pose.positionWo = from.positionWo + (to.positionWo - from.positionWo) * fraction;
    return pose;
}

RigidMotion inertialMotion(const HeadPose& from, const HeadPose& to)
{
    if (from == to)
        return {};
    const glm::quat back = glm::conjugate(to.rotation);
    const glm::quat turn = back * from.rotation;
    const glm::vec3 offset = back * (from.positionWo - to.positionWo);
    if (std::abs(turn.w) < kLeastHalfCosine || glm::dot(offset, offset) > kFurthestM * kFurthestM)
        return {};
    return rigid(glm::mat3_cast(normalised(turn)), offset);
}

NeckTurn neckTurn(const Neck& neck, const HeadPose& pose)
{
    constexpr float kStraight = 1e-6F;
    const glm::vec3 axis(pose.rotation.x, pose.rotation.y, pose.rotation.z);
    if (!neck.hasShoulders() || glm::dot(axis, axis) < kStraight * kStraight)
        return {};
    const glm::quat turn = pose.rotation.w < 0.0F ? -pose.rotation : pose.rotation;
    return {.turned = true,
            .pivot = {neck.pivotHd.x, neck.pivotHd.y, neck.pivotHd.z},
            .turn = {turn.x, turn.y, turn.z, turn.w},
            .headY = neck.headY,
            .perTwistM = 1.0F / (neck.headY - neck.shouldersY),
            .shouldersY = neck.shouldersY};
}

RigidMotion worldOfHead(const HeadPose& pose)
{
    return rigid(glm::mat3_cast(pose.rotation), pose.positionWo);
}

glm::vec3 directionToHead(const HeadPose& pose, glm::vec3 directionWo)
{
    return glm::conjugate(pose.rotation) * directionWo;
}

glm::vec3 pointToHead(const HeadPose& pose, glm::vec3 pointWo)
{
    return directionToHead(pose, pointWo - pose.positionWo);
}

HeadPose sanePose(const HeadPose& pose, const HeadPose& fallback)
{
    const glm::quat& q = pose.rotation;
    const float norm2 = glm::dot(q, q);
    const float sum = pose.positionWo.x + pose.positionWo.y + pose.positionWo.z;
    if (!std::isfinite(norm2) || !std::isfinite(sum) || norm2 < 1e-12F)
        return fallback;
    if (std::abs(norm2 - 1.0F) < 1e-6F)
        return pose;
    return {normalised(q), pose.positionWo};
}

} // namespace hairpaint::sim
