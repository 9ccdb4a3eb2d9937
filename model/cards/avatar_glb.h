// An avatar's joints and what VRM 1.0 says of it, as JSON of a glTF.
#pragma once

#include "model/cards/avatar_body.h"

#include <QJsonArray>
#include <QJsonObject>

#include <vector>

namespace hairpaint::model {

struct AvatarGlb
{
    QJsonArray nodes;  ///< The skeleton's joints; the first, their root, has the number `firstNode`.
    QJsonArray joints; ///< Indices of their nodes.
    std::vector<glm::mat4> inverseBind;
    QJsonObject vrm; ///< VRMC_vrm.
    int headNode = 0;
};

[[nodiscard]] AvatarGlb avatarGlb(const Avatar& avatar, const AvatarBody& body, int firstNode);

} // namespace hairpaint::model
