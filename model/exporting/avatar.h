// A head that came with a whole body's skeleton, as an avatar to be exported.
#pragma once

#include "model/heads/humanoid_bones.h"
#include "model/project/project.h"
#include "model/values/sentences.h"

#include <QString>

#include <memory>

namespace hairpaint::model {

/// A head with skeleton, body and the texts that name it. Immutable.
struct Avatar
{
    static constexpr int kLongestText = 200;

    QString name;          ///< Name of the avatar, without line breaks.
    QString author;        ///< Author of the avatar, without line breaks.
    HeadSkeleton skeleton; ///< Hd.
    HumanoidBones bones;
    std::shared_ptr<const sim::Skin> skin; ///< The head's skin; the skeleton's weights are by its vertices.
    std::vector<HeadPart> parts = {};      ///< The parts of the body, Hd.
    std::vector<std::vector<BoneWeights>> partWeights = {}; ///< By part: the weights of its vertices.
};

/// A clause that says what is missing and what to do, where the head has no such skeleton. Texts that are empty are
/// "Unknown".
[[nodiscard]] Checked<std::shared_ptr<const Avatar>> avatarOf(const Head& head, const QString& name,
                                                              const QString& author);

} // namespace hairpaint::model
