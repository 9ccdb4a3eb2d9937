// The one table of a hair group's settings: files, panel, limits and the format's documentation read it.
#pragma once

#include "sim/groom/group_settings.h"

#include <QString>

#include <span>
#include <variant>

namespace hairpaint::model {

/// Where the panel shows it.
enum class SettingSection
{
    Shape,
    Variation,
    Braid,
    Physics,
    Look
};

using sim::SettingMember;

/// A value of a setting that is one of a few.
struct SettingChoice
{
    const char* id;    ///< In files.
    const char* title; ///< To be translated in context "GroupSchema".
};

/// A row of the table; what a setting affects, sim::affectsOf(member) tells. Numbers, switches (0 or 1) and choices (an
/// index) are all read and written as a double, in SI units. Its members stand as rows are read.
// NOLINTNEXTLINE(clang-analyzer-optin.performance.Padding)
struct GroupSetting
{
    const char* key; ///< In files; "physics.friction" is the key friction of the object physics.
    SettingMember member;
    SettingSection section;
    const char* label;                  ///< To be translated in context "GroupSchema", as are the following.
    const char* hint;                   ///< What the smallest and the greatest value mean.
    const char* unit;                   ///< Of the number shown; "" for none.
    double shownPerSi;                  ///< The number shown is the SI value times this.
    double least, greatest;             ///< In files, SI.
    double sliderLeast, sliderGreatest; ///< In the panel, in the unit shown; within what files may hold.
    int decimals = 0;
    float exponent = 1.0F;                       ///< Of the slider's scale: above 1 small values have more room.
    std::span<const SettingChoice> choices = {}; ///< The values of a setting that is a choice.
    /// A number of hairs over the whole skin, shown as how many of them stand on the scalp (see Head::scalpFraction).
    bool countsOnScalp = false;

    [[nodiscard]] double read(const sim::GroupSettings& settings) const;
    /// Rounded where the member is a whole number; the caller keeps it between `least` and `greatest`.
    void write(sim::GroupSettings& settings, double value) const;
    /// In the unit shown. What is written and then shown is the same number.
    [[nodiscard]] double shown(const sim::GroupSettings& settings, double scalpFraction) const;
    void writeShown(sim::GroupSettings& settings, double value, double scalpFraction) const;
    [[nodiscard]] bool isSwitch() const { return std::holds_alternative<bool sim::GroupSettings::*>(member); }
    [[nodiscard]] bool isInteger() const { return std::holds_alternative<int sim::GroupSettings::*>(member); }
};

/// In the panel's order within each section.
[[nodiscard]] std::span<const GroupSetting> groupSchema();
/// The row of that key; there must be one.
[[nodiscard]] const GroupSetting& groupSetting(QLatin1StringView key);
/// How much the hairs of people differ, grey ones aside. What is begun by hand starts with it; what files and scripts
/// begin is exactly what its maps say.
[[nodiscard]] sim::VariationSettings naturalVariation();
/// What is begun by hand ends as cut hair does: it thins out over its last centimetre alone.
void setNaturalEnds(sim::GroupSettings& settings);
/// What a new group starts with: 4,096 basis hairs on the scalp.
[[nodiscard]] sim::GroupSettings newGroupSettings(double scalpFraction);
[[nodiscard]] QString schemaText(const char* text); ///< Translated; empty stays empty.

} // namespace hairpaint::model
