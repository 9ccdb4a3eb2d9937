// An avatar's body and joints as VRM 1.0 wants them: upright, the face toward +z, the arms held out to the sides.
#pragma once

#include "model/exporting/avatar.h"
#include "model/exporting/posed_mesh.h"

#include <vector>

namespace hairpaint::model {

struct AvatarBody
{
    glm::quat turn{1, 0, 0, 0};   ///< From Hd, about y.
    std::vector<JointPose> poses; ///< Of the skeleton's joints.
    PosedMesh mesh;
    std::vector<PosedMesh> parts = {}; ///< The avatar's.
};

[[nodiscard]] AvatarBody avatarBody(const Avatar& avatar);

} // namespace hairpaint::model
