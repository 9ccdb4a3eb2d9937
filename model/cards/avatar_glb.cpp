// Nodes of joints; VRMC_vrm 1.0 (VRM Consortium).
#include "model/cards/avatar_glb.h"

#include "model/files/joint_nodes.h"

namespace hairpaint::model {

namespace {

/// What it does not say is as VRM has it unless told: the author alone may use it.
QJsonObject metaOf(const Avatar& avatar)
{
    return {{QStringLiteral("name"), avatar.name},
            {QStringLiteral("authors"), QJsonArray{avatar.author}},
            {QStringLiteral("licenseUrl"), QStringLiteral("https://vrm.dev/licenses/1.0/")}};
}

} // namespace

AvatarGlb avatarGlb(const Avatar& avatar, const AvatarBody& body, int firstNode)
{
    HeadSkeleton skeleton{.joints = avatar.skeleton.joints, .weights = {}};
    setPoses(skeleton, body.poses);
    AvatarGlb made{.nodes = nodesOf(skeleton, firstNode),
                   .joints = jointNumbers(skeleton, firstNode),
                   .inverseBind = {},
                   .vrm = {},
                   .headNode = firstNode + avatar.bones[HumanBone::Head]};
    for (const JointPose& pose : body.poses)
        made.inverseBind.push_back(inverseBind(pose));
    QJsonObject bones;
    for (std::size_t i = 0; i < kHumanBoneCount; ++i) {
        const auto bone = static_cast<HumanBone>(i);
        if (avatar.bones[bone] >= 0)
            bones.insert(QLatin1StringView(humanBoneSpec(bone).id),
                         QJsonObject{{QStringLiteral("node"), firstNode + avatar.bones[bone]}});
    }
    made.vrm = {{QStringLiteral("specVersion"), QStringLiteral("1.0")},
                {QStringLiteral("meta"), metaOf(avatar)},
                {QStringLiteral("humanoid"), QJsonObject{{QStringLiteral("humanBones"), bones}}}};
    return made;
}

} // namespace hairpaint::model
