// What can grow on a head, and what its hair is like.
#pragma once

#include "model/project/project.h"

#include <QString>

#include <span>

namespace hairpaint::model {

/// A kind of hair that a new group starts as.
struct HairKind
{
    const char* name;  ///< The group's name in files; to be translated by model::shownName.
    const char* title; ///< In the list, to be translated in context "HairKinds".
    void (*apply)(sim::GroupSettings& settings);
    bool ofEveryFace = false; ///< Else it grows only where it is asked for.
};

[[nodiscard]] std::span<const HairKind> hairKinds();
[[nodiscard]] QString titleOf(const HairKind& kind); ///< Translated.

/// Whether the group is of a kind that every face has: brows, lashes.
[[nodiscard]] bool isFaceHair(const HairGroup& group);

} // namespace hairpaint::model
