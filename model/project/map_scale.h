// What the values of scalar maps mean in a group's units.
#pragma once

#include "sim/groom/group_settings.h"

#include <QString>

#include <span>

namespace hairpaint::model {

/// One unit with its range. Maps may share one.
struct MapScale
{
    QString (*unit)(const sim::GroupSettings& settings); ///< "cm", translated.
    int (*decimals)(const sim::GroupSettings& settings);
    /// From a map's 0..1 to the number shown, and back; a number beyond the range gives a value beyond 0..1.
    double (*shown)(const sim::GroupSettings& settings, double value);
    double (*value)(const sim::GroupSettings& settings, double shown);
    /// Values that panels offer; null or empty: round numbers within the range.
    std::span<const double> (*steps)(const sim::GroupSettings& settings) = nullptr;
    double sliderExponent = 1.0; ///< Exponent of a slider's scale: above 1, low values have more room.
    /// What a number shown is in a unit that is the same for all groups; null: all groups show the same unit.
    double (*common)(const sim::GroupSettings& settings) = nullptr;

    /// From 0..1 to an amount that can be compared between groups, and back, clamped to 0..1.
    [[nodiscard]] double amount(const sim::GroupSettings& settings, double fraction) const;
    [[nodiscard]] double fraction(const sim::GroupSettings& settings, double amount) const;
};

extern const MapScale kDensityScale; ///< Hairs a square centimetre; for the density map.
extern const MapScale kLengthScale;  ///< Length of hair, centimetres, or millimetres where hair is short.
extern const MapScale kTurnsScale;   ///< Number of turns, as in the paper's table 1.
extern const MapScale kRadiusScale;  ///< Radius of curls, millimetres.
extern const MapScale kFrizzScale;   ///< How far hair strays, millimetres.
extern const MapScale kWidthScale;   ///< Per cent of the group's hair width, 30 to 170.
extern const MapScale kPercentScale; ///< Per cent.

} // namespace hairpaint::model
