// The head's skeleton and its bones.
#include "model/exporting/avatar.h"

#include "model/files/glb.h"
#include "model/files/head_file.h"

namespace hairpaint::model {

namespace {

QString plainText(const QString& text)
{
    const QString plain = text.simplified().left(Avatar::kLongestText);
    return plain.isEmpty() ? QStringLiteral("Unknown") : plain;
}

} // namespace

Checked<std::shared_ptr<const Avatar>> avatarOf(const Head& head, const QString& name, const QString& author)
{
    Checked<HeadSkeleton> skeleton = skeletonOf(head);
    if (!skeleton)
        return tl::unexpected(skeleton.error());
    const Checked<HumanoidBones> bones = humanoidBones(skeleton->joints);
    if (!bones)
        return tl::unexpected(bones.error());
    auto avatar = std::make_shared<Avatar>();
    avatar->name = plainText(name);
    avatar->author = plainText(author);
    avatar->skeleton = std::move(*skeleton);
    avatar->bones = *bones;
    avatar->skin = head.skin;
    avatar->parts = head.parts;
    if (!head.parts.empty()) {
        Checked<GlbParts> parts = partsFromGlb(head.sourceGlb);
        if (!parts)
            return tl::unexpected(parts.error());
        avatar->partWeights = std::move(parts->weights);
    }
    return avatar;
}

} // namespace hairpaint::model
