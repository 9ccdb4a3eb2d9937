// What can grow on a head, and what its hair is like.
#pragma once

#include "sim/groom/group_settings.h"

#include <QString>

#include <span>

namespace hairpaint::model {

/// A kind of hair that a new group starts as.
struct HairKind
{
    const char* name;  ///< The group's name in files; to be translated by model::shownName.
    const char* title; ///< In the list, to be translated in context "HairKinds".
    void (*apply)(sim::GroupSettings& settings);
};

[[nodiscard]] std::span<const HairKind> hairKinds();
[[nodiscard]] QString titleOf(const HairKind& kind); ///< Translated.

} // namespace hairpaint::model
