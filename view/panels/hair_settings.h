// The one table of a hair group's numbers: what the hair panel shows, in which unit and between which bounds.
#pragma once

#include "sim/groom/group_settings.h"

#include <QString>

#include <span>

namespace hairpaint::view {

enum class SettingSection
{
    Shape,
    Braid,
    Physics,
    Look
};

/// Read and written in the unit shown.
struct SettingRow
{
    SettingSection section;
    const char* label; ///< To be translated in context "HairSettings".
    const char* hint;  ///< Likewise: what the smallest and the greatest value mean.
    const char* unit;  ///< Likewise; "" for none.
    double minimum, maximum;
    int decimals;
    float exponent;
    double (*read)(const sim::GroupSettings&);
    void (*write)(sim::GroupSettings&, double);
};

[[nodiscard]] std::span<const SettingRow> settingRows();
[[nodiscard]] QString settingText(const char* text); ///< Translated.

} // namespace hairpaint::view
