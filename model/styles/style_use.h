// What of a style is put on a head, and what of the head's hair stays.
#pragma once

#include "model/styles/preset.h"

#include <QString>

#include <span>
#include <vector>

namespace hairpaint::model {

enum class StylePart : std::uint8_t
{
    All,
    Colour,
    Cut, ///< Length, where and how densely hair grows, and in which direction it is combed.
    Curl,
    Ties ///< What is worn in the hair, patches and braids.
};

/// A row of the table of parts. A map or a setting that no row names comes with the whole style alone.
struct StylePartSpec
{
    StylePart part;
    const char* title; ///< In menus, to be translated in context "StyleParts", as is the next.
    const char* step;  ///< What undo says; %1 is the style's name.
    std::span<const MapKind> maps = {};
    std::span<const char* const> settings = {}; ///< Keys of groupSchema().
    bool worn = false;                          ///< With what is worn in the group's hair.
    [[nodiscard]] QString titleText() const;    ///< Translated.
};
[[nodiscard]] std::span<const StylePartSpec> styleParts(); ///< In the order of StylePart.
[[nodiscard]] const StylePartSpec& stylePart(StylePart part);

struct StyleUse
{
    StylePart part = StylePart::All;
    std::vector<Id> kept = {}; ///< Groups of the project that stay, though the style has one of their name.
    /// 0..1: below 1 each group is mixed with the one that it replaces (style_mix.h); ties and groups that the project
    /// has none of come with a half and more.
    double fraction = 1.0;
};

/// Whether anything of the group's density is above 0.
[[nodiscard]] bool growsHair(const HairGroup& group);

/// Groups of the project that the style has one of the same name for. A style is about its groups that grow hair, or,
/// where none does, about all of them: a bald head saved with a beard is a beard.
[[nodiscard]] std::vector<Id> groupsReplaced(const Project& project, const Preset& preset);
/// Those of them that grow hair and that the style is not evidently about: neither the scalp nor the one region of the
/// face that a style of a single group is for.
[[nodiscard]] std::vector<Id> groupsContested(const Project& project, const Preset& preset);

/// Replaces the groups that a preset is about by its own, or a part of them; a group of that name keeps its id and its
/// index in the list, all others stay as they are.
void applyPreset(Project& project, const Preset& preset, const StyleUse& use = {});
/// What undo calls it.
[[nodiscard]] QString applyPresetText(const Preset& preset, StylePart part = StylePart::All, double fraction = 1.0);

} // namespace hairpaint::model
