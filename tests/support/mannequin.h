// A body of boxes under a ball for a head, with a skeleton.
#pragma once

#include "model/heads/rigged_mesh.h"
#include "sim/base/rounded.h"
#include "tests/support/test_heads.h"

#include <algorithm>
#include <array>
#include <string>

namespace hairpaint::test {

/// Metres, y up, the face toward +z.
struct MannequinJoint
{
    const char* name;
    int parent;
    glm::vec3 position;
};

/// Mixamo's names; the arms as those of a T.
inline constexpr std::array<MannequinJoint, 21> kMannequin = {{
    {"mixamorig:Hips", -1, {0.0F, 0.95F, 0.0F}},          {"mixamorig:Spine", 0, {0.0F, 1.05F, 0.0F}},
    {"mixamorig:Spine1", 1, {0.0F, 1.15F, 0.0F}},         {"mixamorig:Spine2", 2, {0.0F, 1.25F, 0.0F}},
    {"mixamorig:Neck", 3, {0.0F, 1.42F, 0.0F}},           {"mixamorig:Head", 4, {0.0F, 1.5F, 0.0F}},
    {"mixamorig:LeftShoulder", 3, {0.05F, 1.4F, 0.0F}},   {"mixamorig:LeftArm", 6, {0.18F, 1.4F, 0.0F}},
    {"mixamorig:LeftForeArm", 7, {0.45F, 1.4F, 0.0F}},    {"mixamorig:LeftHand", 8, {0.7F, 1.4F, 0.0F}},
    {"mixamorig:RightShoulder", 3, {-0.05F, 1.4F, 0.0F}}, {"mixamorig:RightArm", 10, {-0.18F, 1.4F, 0.0F}},
    {"mixamorig:RightForeArm", 11, {-0.45F, 1.4F, 0.0F}}, {"mixamorig:RightHand", 12, {-0.7F, 1.4F, 0.0F}},
    {"mixamorig:LeftUpLeg", 0, {0.1F, 0.9F, 0.0F}},       {"mixamorig:LeftLeg", 14, {0.1F, 0.5F, 0.0F}},
    {"mixamorig:LeftFoot", 15, {0.1F, 0.08F, 0.0F}},      {"mixamorig:RightUpLeg", 0, {-0.1F, 0.9F, 0.0F}},
    {"mixamorig:RightLeg", 17, {-0.1F, 0.5F, 0.0F}},      {"mixamorig:RightFoot", 18, {-0.1F, 0.08F, 0.0F}},
    {"mixamorig:HeadTop_End", 5, {0.0F, 1.75F, 0.0F}},
}};
inline constexpr int kMannequinHead = 5;

/// A box from joint to joint that follows the first. All lie on the lowest twentieth of the uv square.
inline void addLimb(model::RiggedMesh& body, int joint, const glm::vec3& from, const glm::vec3& to)
{
    constexpr float kHalf = 0.04F;
    constexpr float kUsed = 0.04F;
    const glm::vec3 least = glm::min(from, to) - kHalf;
    const glm::vec3 size = glm::max(from, to) + kHalf - least;
    for (int axis = 0; axis < 3; ++axis)
        for (const bool isFar : {false, true}) {
            const auto first = static_cast<std::uint32_t>(body.positionsHd.size());
            for (int corner = 0; corner < 4; ++corner) {
                const glm::vec2 uv(corner % 2, corner / 2);
                glm::vec3 unit(0.0F);
                unit[axis] = isFar ? 1.0F : 0.0F;
                unit[(axis + 1) % 3] = uv.x;
                unit[(axis + 2) % 3] = uv.y;
                glm::vec3 normal(0.0F);
                normal[axis] = isFar ? 1.0F : -1.0F;
                body.positionsHd.push_back(least + unit * size);
                body.normalsHd.push_back(normal);
                body.uvs.push_back(uv * kUsed + glm::vec2(0.045F * static_cast<float>(joint), 0.0F));
                body.skeleton.weights.push_back({.joints = {static_cast<std::uint16_t>(joint), 0, 0, 0}});
            }
            const glm::uvec3 a(first, first + 1, first + 3);
            const glm::uvec3 b(first, first + 3, first + 2);
            body.triangles.push_back(isFar ? a : glm::uvec3(a.x, a.z, a.y));
            body.triangles.push_back(isFar ? b : glm::uvec3(b.x, b.z, b.y));
        }
}

/// `droop`: how far the arms hang from the T, rad.
inline model::RiggedMesh makeMannequin(float droop = 0.0F, int headSegments = 24)
{
    model::RiggedMesh body(makeBallHead(headSegments, 0.12F));
    for (glm::vec3& position : body.positionsHd)
        position += glm::vec3(0.0F, 1.62F, 0.0F);
    for (glm::vec2& uv : body.uvs)
        uv.y = 0.05F + 0.95F * uv.y;
    body.skeleton.weights.assign(body.positionsHd.size(), {.joints = {kMannequinHead, 0, 0, 0}});
    std::vector<model::JointPose> poses;
    for (const MannequinJoint& joint : kMannequin) {
        glm::vec3 position = joint.position;
        const float outward = std::abs(position.x) - 0.18F;
        if (outward > 0.0F) {
            position.x = std::copysign(0.18F + outward * sim::cosRounded(droop), position.x);
            position.y -= outward * sim::sinRounded(droop);
        }
        poses.push_back({.position = position});
        body.skeleton.joints.push_back({.name = joint.name, .parent = joint.parent});
    }
    setPoses(body.skeleton, poses);
    for (std::size_t i = 0; i < kMannequin.size(); ++i)
        if (const int parent = kMannequin[i].parent; parent >= 0 && parent != kMannequinHead)
            addLimb(body, parent, poses[static_cast<std::size_t>(parent)].position, poses[i].position);
    return body;
}

} // namespace hairpaint::test
