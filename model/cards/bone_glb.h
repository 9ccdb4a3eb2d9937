// Joints of what hangs, and how they swing, as JSON of a glTF.
#pragma once

#include "model/cards/card_bones.h"
#include "model/exporting/curve_set.h"
#include "sim/skin/ellipsoid.h"

#include <QJsonArray>
#include <QJsonObject>

#include <span>
#include <vector>

namespace hairpaint::model {

/// The joint that all chains hang from.
struct BoneRoot
{
    int node = 0; ///< Index of its node.
    JointPose pose;
};

/// Joints one after another, each the parent of the next; the last only tells where the hair or the ribbon ends.
struct SpringChain
{
    QString name;
    std::vector<glm::vec3> joints;  ///< Where they stand in the file, two at least.
    sim::PhysicsSettings physics{}; ///< Of the hair, or as if it were hair.
};
/// Those of hair; `frame`: where the space of the chains stands in the file.
[[nodiscard]] std::vector<SpringChain> springsOf(const CurveSet& curves, const std::vector<BoneChain>& chains,
                                                 const JointPose& frame = {});

struct BoneGlb
{
    QJsonArray nodes;  ///< Each chain's joints; the first has the number `firstNode`.
    QJsonArray below;  ///< Those of them that are the root's children.
    QJsonArray joints; ///< Numbers: the root, then these.
    std::vector<glm::mat4> inverseBind;
    QJsonObject springBone; ///< VRMC_springBone.
};

/// Joints of the chains. `colliders`: Hd; `head`: where that is in the file.
[[nodiscard]] BoneGlb boneGlb(std::span<const SpringChain> chains, std::span<const sim::Ellipsoid> colliders,
                              const JointPose& head, const BoneRoot& root, int firstNode);

} // namespace hairpaint::model
