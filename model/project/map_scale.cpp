// Units and ranges of the scalar maps.
#include "model/project/map_scale.h"

#include "sim/groom/strand_style.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <array>
#include <cmath>

namespace hairpaint::model {

namespace {

using sim::GroupSettings;

constexpr double kPerSquareCm = 1e-4;
constexpr double kShortGroupM = 0.03; ///< Groups with shorter hair are measured in mm.
constexpr double kSparse = 20.0;      ///< Hairs a square centimetre, of which tenths count.

constexpr double kLeastWidth = 30.0; ///< Per cent of the group's, as sim::widthOf has it.
constexpr double kMostWidth = 170.0;

constexpr std::array kTurnSteps{0.0, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0};

struct Units
{
    Q_DECLARE_TR_FUNCTIONS(MapScale)
};

template<int decimals>
int always(const GroupSettings&)
{
    return decimals;
}

double greatestDensity(const GroupSettings& settings)
{
    return static_cast<double>(settings.greatestDensityPerM2) * kPerSquareCm;
}

double greatestRadiusMm(const GroupSettings& settings)
{
    // The map's default, its middle, is half a coil's diameter.
    return static_cast<double>(settings.turnsMode == sim::TurnsMode::Coils ? settings.curl.diameterM
                                                                           : settings.greatestCurlRadiusM) *
           1000.0;
}

double greatestFrizzMm(const GroupSettings& settings)
{
    return static_cast<double>(settings.greatestFrizzM) * 1000.0;
}

double lengthScale(const GroupSettings& settings)
{
    return static_cast<double>(settings.greatestLengthM) < kShortGroupM ? 1000.0 : 100.0;
}

QString turnsUnit(const GroupSettings& settings)
{
    if (settings.turnsMode == sim::TurnsMode::PerHair)
        return Units::tr("turns");
    if (settings.turnsMode == sim::TurnsMode::Coils)
        return QStringLiteral("%"); // The map holds a percentage of the turns that the group's pitch gives.
    return Units::tr("turns per %1 cm")
        .arg(QLocale().toString(static_cast<double>(settings.turnsPerLengthM) * 100.0, 'g', 3));
}

double turnsAt(const GroupSettings& settings, double red)
{
    if (settings.turnsMode == sim::TurnsMode::Coils)
        return red * 100.0;
    return static_cast<double>(sim::turnsOfCurl(static_cast<float>(red), false));
}

std::span<const double> turnSteps(const GroupSettings& settings)
{
    return settings.turnsMode == sim::TurnsMode::Coils ? std::span<const double>{} : kTurnSteps;
}

/// The table rises from level to level.
double redOf(const GroupSettings& settings, double turns)
{
    constexpr int kLevels = 5;
    for (int level = 0; level < kLevels; ++level) {
        const double low = turnsAt(settings, static_cast<double>(level) / kLevels);
        const double high = turnsAt(settings, static_cast<double>(level + 1) / kLevels);
        if (turns <= high)
            return (level + std::max(0.0, turns - low) / (high - low)) / kLevels;
    }
    return 1.0;
}

} // namespace

double MapScale::amount(const GroupSettings& settings, double fraction) const
{
    return shown(settings, fraction) * (common != nullptr ? common(settings) : 1.0);
}

double MapScale::fraction(const GroupSettings& settings, double amount) const
{
    return std::clamp(value(settings, amount / (common != nullptr ? common(settings) : 1.0)), 0.0, 1.0);
}

const MapScale kDensityScale{
    .unit = [](const GroupSettings&) { return Units::tr("hairs/cm²"); },
    .decimals = [](const GroupSettings& settings) { return greatestDensity(settings) < kSparse ? 1 : 0; },
    .shown = [](const GroupSettings& settings, double value) { return value * greatestDensity(settings); },
    .value = [](const GroupSettings& settings, double shown) { return shown / greatestDensity(settings); }};

const MapScale kLengthScale{
    .unit =
        [](const GroupSettings& settings) { return lengthScale(settings) > 100.0 ? Units::tr("mm") : Units::tr("cm"); },
    .decimals = always<1>,
    .shown =
        [](const GroupSettings& settings, double value) {
            return lengthScale(settings) * std::lerp(static_cast<double>(settings.shortestLengthM),
                                                     static_cast<double>(settings.greatestLengthM), value);
        },
    .value =
        [](const GroupSettings& settings, double shown) {
            const auto shortest = static_cast<double>(settings.shortestLengthM);
            const double range = static_cast<double>(settings.greatestLengthM) - shortest;
            return range > 0.0 ? (shown / lengthScale(settings) - shortest) / range : 0.0;
        },
    .common = [](const GroupSettings& settings) { return 1.0 / lengthScale(settings); }};

const MapScale kTurnsScale{.unit = turnsUnit,
                           .decimals = always<1>,
                           .shown = turnsAt,
                           .value = redOf,
                           .steps = turnSteps,
                           .sliderExponent = 2.0};

const MapScale kRadiusScale{
    .unit = [](const GroupSettings&) { return Units::tr("mm"); },
    .decimals = always<1>,
    .shown = [](const GroupSettings& settings, double value) { return value * greatestRadiusMm(settings); },
    .value =
        [](const GroupSettings& settings, double shown) {
            const double greatest = greatestRadiusMm(settings);
            return greatest > 0.0 ? shown / greatest : 0.0;
        }};

const MapScale kFrizzScale{
    .unit = [](const GroupSettings&) { return Units::tr("mm"); },
    .decimals = always<1>,
    .shown = [](const GroupSettings& settings, double value) { return value * greatestFrizzMm(settings); },
    .value =
        [](const GroupSettings& settings, double shown) {
            const double greatest = greatestFrizzMm(settings);
            return greatest > 0.0 ? shown / greatest : 0.0;
        }};

const MapScale kWidthScale{
    .unit = [](const GroupSettings&) { return QStringLiteral("%"); },
    .decimals = always<0>,
    .shown = [](const GroupSettings&, double value) { return kLeastWidth + (kMostWidth - kLeastWidth) * value; },
    .value = [](const GroupSettings&, double shown) { return (shown - kLeastWidth) / (kMostWidth - kLeastWidth); }};

const MapScale kPercentScale{.unit = [](const GroupSettings&) { return QStringLiteral("%"); },
                             .decimals = always<0>,
                             .shown = [](const GroupSettings&, double value) { return value * 100.0; },
                             .value = [](const GroupSettings&, double shown) { return shown / 100.0; }};

} // namespace hairpaint::model
