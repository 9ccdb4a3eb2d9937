// The joints of cards, and how they swing, as JSON of a glTF.
#pragma once

#include "model/exporting/cards/card_bones.h"
#include "model/exporting/curve_set.h"
#include "sim/skin/ellipsoid.h"

#include <QJsonArray>
#include <QJsonObject>

#include <span>
#include <vector>

namespace hairpaint::model {

struct BoneGlb
{
    QJsonArray nodes;  ///< The head first, then each chain's joints; the first has the number `firstNode`.
    QJsonArray joints; ///< Their numbers.
    std::vector<glm::mat4> inverseBind;
    QJsonObject springBone; ///< VRMC_springBone.
};

/// A joint for the head and those of the chains below it. `colliders`: Hd.
[[nodiscard]] BoneGlb boneGlb(const CurveSet& curves, const CardBones& bones, std::span<const sim::Ellipsoid> colliders,
                              int firstNode);

} // namespace hairpaint::model
