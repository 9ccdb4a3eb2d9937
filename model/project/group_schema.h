// The one table of a hair group's settings: files, panel, limits and the format's documentation read it.
#pragma once

#include "sim/groom/group_settings.h"

#include <QString>

#include <span>
#include <variant>

namespace hairpaint::model {

/// The section of the panel that shows a setting.
enum class SettingSection
{
    Shape,
    Curl,
    Locks,
    Variation,
    Braid,
    Physics,
    Look
};

using sim::SettingMember;

/// One value of a setting that is a choice.
struct SettingChoice
{
    const char* id;    ///< Name of the value in files.
    const char* title; ///< To be translated in context "GroupSchema".
};

/// A row of the table; sim::affectsOf(member) tells what a setting affects. Numbers, switches (0 or 1) and choices (an
/// index) are all read and written as a double, in SI units. The members are in the order in which rows are written.
// NOLINTNEXTLINE(clang-analyzer-optin.performance.Padding)
struct GroupSetting
{
    const char* key; ///< Key in files; "physics.friction" is the key friction of the object physics.
    SettingMember member;
    SettingSection section;
    const char* label;      ///< To be translated in context "GroupSchema", as are the following.
    const char* hint;       ///< What the smallest and the greatest value mean.
    const char* unit;       ///< Unit of the number shown; "" for none.
    double shownPerSi;      ///< The number shown is the SI value times this.
    double least, greatest; ///< Range in files, SI.
    /// Range of the panel's slider, in the unit shown; within `least` .. `greatest`.
    double sliderLeast, sliderGreatest;
    int decimals = 0;
    float exponent = 1.0F; ///< Exponent of the slider's scale: above 1, small values have more room.
    std::span<const SettingChoice> choices = {}; ///< The values of a setting that is a choice.
    /// A number of hairs over the whole skin, shown as how many of them stand on the scalp (see Head::scalpFraction).
    bool countsOnScalp = false;

    [[nodiscard]] double read(const sim::GroupSettings& settings) const;
    /// Rounded where the member is a whole number; the caller keeps it between `least` and `greatest`.
    void write(sim::GroupSettings& settings, double value) const;
    /// The value in the unit shown; a number that writeShown() wrote comes back the same.
    [[nodiscard]] double shown(const sim::GroupSettings& settings, double scalpFraction) const;
    void writeShown(sim::GroupSettings& settings, double value, double scalpFraction) const;
    [[nodiscard]] bool isSwitch() const { return std::holds_alternative<bool sim::GroupSettings::*>(member); }
    [[nodiscard]] bool isInteger() const { return std::holds_alternative<int sim::GroupSettings::*>(member); }
};

/// All settings, within each section in the panel's order.
[[nodiscard]] std::span<const GroupSetting> groupSchema();
/// The row of that key; there must be one.
[[nodiscard]] const GroupSetting& groupSetting(QLatin1StringView key);
/// Adds variation as on people: no two hairs alike, partings that hairs cross. Groups made by hand start with it; those
/// made by files and scripts follow their maps exactly.
void makeNatural(sim::GroupSettings& settings);
/// What a new group starts with: 4,096 basis hairs on the scalp.
[[nodiscard]] sim::GroupSettings newGroupSettings(double scalpFraction);
[[nodiscard]] QString schemaText(const char* text); ///< Translated; empty stays empty.

} // namespace hairpaint::model
