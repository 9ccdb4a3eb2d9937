// The lights of a scene, and the arrangements of them that come with the program.
#pragma once

#include <QString>
#include <QStringView>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace hairpaint::model {

/// Where the light from all sides comes from.
enum class Surroundings : std::uint8_t
{
    Studio, ///< Soft boxes.
    Daylight,
    Sunset,
    Club,
    Even
};
inline constexpr std::size_t kSurroundingsCount = 5;

/// The model by which a hair scatters light.
enum class Scattering : std::uint8_t
{
    Marschner,
    KajiyaKay,
    IlluminatedLines
};
inline constexpr std::size_t kScatteringCount = 3;

inline constexpr float kLeastTemperatureK = 1700.0F;
inline constexpr float kNeutralTemperatureK = 6500.0F; ///< Colour temperature of the screen's white.
inline constexpr float kGreatestTemperatureK = 15000.0F;

/// Wo. A key light, of which the paper's keys change the colour; a fill that follows the camera, a rim light behind the
/// head as the camera sees it, and surroundings.
struct LightSettings
{
    float azimuthRad = 0.6F;                       ///< Around y from +z toward +x.
    float elevationRad = 0.7F;                     ///< Above the horizon.
    float intensity = 0.9F;                        ///< 0..4
    float ambient = 0.35F;                         ///< 0..1: how bright the surroundings are.
    float red = 1.0F, green = 0.97F, blue = 0.93F; ///< 0..1, linear.
    float temperatureK = kNeutralTemperatureK;     ///< Temperature whose colour multiplies that of the key light.
    float fill = 0.4F;                             ///< 0..2
    float rim = 0.6F;                              ///< 0..4
    Surroundings surroundings = Surroundings::Studio;
    Scattering scattering = Scattering::Marschner;
    friend bool operator==(const LightSettings&, const LightSettings&) = default;
};

/// Linear colour of a black body of that temperature beside one of kNeutralTemperatureK, as bright as it.
[[nodiscard]] std::array<float, 3> temperatureColour(float kelvin);

struct LightPreset
{
    const char* id;    ///< Name on the command line.
    const char* title; ///< To be translated in context "Light".
    LightSettings light;

    [[nodiscard]] QString titleText() const; ///< Translated.
    /// `current` with the lights of this preset; its scattering stays.
    [[nodiscard]] LightSettings appliedTo(const LightSettings& current) const;
};
[[nodiscard]] std::span<const LightPreset> lightPresets();
[[nodiscard]] const LightPreset* findLightPreset(QStringView id); ///< Null where none has that id.

/// A value of an enumeration: its id in files and its title, to be translated in context "Light".
struct NamedValue
{
    const char* id;
    const char* title;
    [[nodiscard]] QString titleText() const;
};
[[nodiscard]] std::span<const NamedValue, kSurroundingsCount> surroundingsNames(); ///< In the order of Surroundings.
[[nodiscard]] std::span<const NamedValue, kScatteringCount> scatteringNames();     ///< In the order of Scattering.

} // namespace hairpaint::model
