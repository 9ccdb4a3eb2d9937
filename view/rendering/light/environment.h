// The light of built-in surroundings, in nine numbers a colour.
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>

namespace hairpaint::rendering {

/// Irradiance over pi by the normal, as spherical harmonics up to the second band, not normalised: factors of 1, y, z,
/// x, xy, yz, 3zz-1, xz, xx-yy (Ramamoorthi and Hanrahan 2001). Linear colours.
using Irradiance = std::array<glm::vec3, 9>;

enum class EnvironmentKind : std::uint8_t
{
    Studio,
    Daylight,
    Sunset,
    Club,
    Even
};
inline constexpr std::size_t kEnvironmentCount = 5;

/// The irradiance of built-in surroundings; its mean brightness is 1.
[[nodiscard]] const Irradiance& irradianceOf(EnvironmentKind surroundings);

} // namespace hairpaint::rendering
