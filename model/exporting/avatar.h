// A head that came with a whole body's skeleton, as an avatar to be exported.
#pragma once

#include "model/heads/humanoid_bones.h"
#include "model/project/project.h"
#include "model/values/sentences.h"

#include <QString>

#include <memory>

namespace hairpaint::model {

/// Immutable.
struct Avatar
{
    static constexpr int kLongestText = 200;

    QString name;          ///< Without line breaks.
    QString author;        ///< Likewise.
    HeadSkeleton skeleton; ///< Hd.
    HumanoidBones bones;
    std::shared_ptr<const sim::Skin> skin;                  ///< Whose vertices the skeleton's weights are for.
    std::vector<HeadPart> parts = {};                       ///< Of its body, Hd,
    std::vector<std::vector<BoneWeights>> partWeights = {}; ///< with the weights of their vertices.
};

/// A clause that says what is missing and what to do, where the head has no such skeleton. Texts that are empty are
/// "Unknown".
[[nodiscard]] Checked<std::shared_ptr<const Avatar>> avatarOf(const Head& head, const QString& name,
                                                              const QString& author);

} // namespace hairpaint::model
