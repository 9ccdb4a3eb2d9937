// Presets, names and the colour of a temperature.
#include "model/project/light_settings.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace hairpaint::model {

namespace {

constexpr std::array<LightPreset, 5> kPresets{{
    {"studio", QT_TRANSLATE_NOOP("Light", "Studio"), {}},
    {"daylight",
     QT_TRANSLATE_NOOP("Light", "Daylight"),
     {.azimuthRad = 0.9F,
      .elevationRad = 0.95F,
      .intensity = 1.3F,
      .ambient = 0.5F,
      .red = 1.0F,
      .green = 1.0F,
      .blue = 1.0F,
      .temperatureK = 5600.0F,
      .fill = 0.08F,
      .rim = 0.2F,
      .surroundings = Surroundings::Daylight}},
    {"sunset",
     QT_TRANSLATE_NOOP("Light", "Sunset"),
     {.azimuthRad = 1.9F,
      .elevationRad = 0.2F,
      .intensity = 1.8F,
      .ambient = 0.4F,
      .red = 1.0F,
      .green = 1.0F,
      .blue = 1.0F,
      .temperatureK = 2700.0F,
      .fill = 0.15F,
      .rim = 0.5F,
      .surroundings = Surroundings::Sunset}},
    {"club",
     QT_TRANSLATE_NOOP("Light", "Club"),
     {.azimuthRad = -0.9F,
      .elevationRad = 0.5F,
      .intensity = 0.8F,
      .ambient = 0.5F,
      .red = 0.9F,
      .green = 0.35F,
      .blue = 1.0F,
      .temperatureK = kNeutralTemperatureK,
      .fill = 0.05F,
      .rim = 1.2F,
      .surroundings = Surroundings::Club}},
    {"backlit",
     QT_TRANSLATE_NOOP("Light", "Backlit"),
     {.azimuthRad = 2.75F,
      .elevationRad = 0.5F,
      .intensity = 2.2F,
      .ambient = 0.25F,
      .red = 1.0F,
      .green = 1.0F,
      .blue = 1.0F,
      .temperatureK = 5000.0F,
      .fill = 0.3F,
      .rim = 1.2F,
      .surroundings = Surroundings::Studio}},
}};

constexpr std::array<NamedValue, kSurroundingsCount> kSurroundings{{
    {"studio", QT_TRANSLATE_NOOP("Light", "Studio")},
    {"daylight", QT_TRANSLATE_NOOP("Light", "Daylight")},
    {"sunset", QT_TRANSLATE_NOOP("Light", "Sunset")},
    {"club", QT_TRANSLATE_NOOP("Light", "Club")},
    {"even", QT_TRANSLATE_NOOP("Light", "Even")},
}};

constexpr std::array<NamedValue, kScatteringCount> kScattering{{
    {"marschner", QT_TRANSLATE_NOOP("Light", "Marschner")},
    {"kajiya_kay", QT_TRANSLATE_NOOP("Light", "Kajiya-Kay")},
    {"illuminated_lines", QT_TRANSLATE_NOOP("Light", "Illuminated lines")},
}};

/// Linear sRGB of the Planckian locus, as Kim and others 2002 fit it, at luminance 1.
std::array<double, 3> blackBody(double kelvin)
{
    const double t = 1000.0 / kelvin;
    const double x = kelvin < 4000.0 ? ((-0.2661239 * t - 0.2343589) * t + 0.8776956) * t + 0.179910
                                     : ((-3.0258469 * t + 2.1070379) * t + 0.2226347) * t + 0.240390;
    double y = 0.0;
    if (kelvin < 2222.0)
        y = ((-1.1063814 * x - 1.34811020) * x + 2.18555832) * x - 0.20219683;
    else if (kelvin < 4000.0)
        y = ((-0.9549476 * x - 1.37418593) * x + 2.09137015) * x - 0.16748867;
    else
        y = ((3.0817580 * x - 5.87338670) * x + 3.75112997) * x - 0.37001483;
    const double bigX = x / y;
    const double bigZ = (1.0 - x - y) / y;
    return {3.2404542 * bigX - 1.5371385 - 0.4985314 * bigZ, -0.9692660 * bigX + 1.8760108 + 0.0415560 * bigZ,
            0.0556434 * bigX - 0.2040259 + 1.0572252 * bigZ};
}

} // namespace

std::array<float, 3> temperatureColour(float kelvin)
{
    const auto bounded = static_cast<double>(std::clamp(kelvin, kLeastTemperatureK, kGreatestTemperatureK));
    const std::array<double, 3> colour = blackBody(bounded);
    const std::array<double, 3> white = blackBody(static_cast<double>(kNeutralTemperatureK));
    constexpr std::array<double, 3> kLuminance{0.2126, 0.7152, 0.0722};
    std::array<double, 3> relative{};
    double luminance = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        relative.at(i) = std::max(colour.at(i) / white.at(i), 0.0);
        luminance += kLuminance.at(i) * relative.at(i);
    }
    std::array<float, 3> result{};
    std::ranges::transform(relative, result.begin(),
                           [luminance](double channel) { return static_cast<float>(channel / luminance); });
    return result;
}

QString LightPreset::titleText() const
{
    return QCoreApplication::translate("Light", title);
}

LightSettings LightPreset::appliedTo(const LightSettings& current) const
{
    LightSettings result = light;
    result.scattering = current.scattering;
    return result;
}

std::span<const LightPreset> lightPresets()
{
    return kPresets;
}

const LightPreset* findLightPreset(QStringView id)
{
    const auto found =
        std::ranges::find_if(kPresets, [id](const LightPreset& preset) { return QLatin1StringView(preset.id) == id; });
    return found != kPresets.end() ? &*found : nullptr;
}

QString NamedValue::titleText() const
{
    return QCoreApplication::translate("Light", title);
}

std::span<const NamedValue, kSurroundingsCount> surroundingsNames()
{
    return kSurroundings;
}

std::span<const NamedValue, kScatteringCount> scatteringNames()
{
    return kScattering;
}

} // namespace hairpaint::model
