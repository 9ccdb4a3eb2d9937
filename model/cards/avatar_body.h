// An avatar's body and joints as VRM 1.0 wants them: upright, the face toward +z, the arms held out to the sides.
#pragma once

#include "model/exporting/avatar.h"
#include "model/exporting/posed_mesh.h"

#include <vector>

namespace hairpaint::model {

struct AvatarBody
{
    glm::quat turn{1, 0, 0, 0};   ///< Rotation about y from Hd to the avatar's space.
    std::vector<JointPose> poses; ///< Poses of the skeleton's joints, by joint.
    PosedMesh mesh;
    std::vector<PosedMesh> parts = {}; ///< The avatar's parts, posed; by part.
};

[[nodiscard]] AvatarBody avatarBody(const Avatar& avatar);

} // namespace hairpaint::model
