// Arithmetic on 16-bit channels, where 65535 is 1.
#pragma once

#include "sim/base/tiled_raster.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace hairpaint::model {

/// An index replaces where coverage * opacity is at least this.
inline constexpr std::uint16_t kHalfCoverage = 32768;
inline constexpr float kFull16 = 65535.0F; ///< A channel of 1.

/// round(a * b / 65535), exactly.
[[nodiscard]] constexpr std::uint16_t mul16(std::uint32_t a, std::uint32_t b)
{
    const std::uint32_t product = a * b + 32768U;
    return static_cast<std::uint16_t>((product + (product >> 16U)) >> 16U);
}

/// round((below * (65535 - fraction) + above * fraction) / 65535), exactly: 0 gives below, 65535 gives above.
[[nodiscard]] constexpr std::uint16_t lerp16(std::uint32_t below, std::uint32_t above, std::uint32_t fraction)
{
    const std::uint32_t sum = below * (65535U - fraction) + above * fraction + 32768U;
    return static_cast<std::uint16_t>((sum + (sum >> 16U)) >> 16U);
}

/// 0..1 as 0..65535, to the nearest.
[[nodiscard]] inline std::uint16_t unit16(float value)
{
    return static_cast<std::uint16_t>(std::lround(std::clamp(value, 0.0F, 1.0F) * kFull16));
}

/// 16 bits as 8, and 8 as 16.
[[nodiscard]] constexpr int narrowed(std::uint16_t channel)
{
    return (channel * 255 + 32767) / 65535;
}
[[nodiscard]] constexpr std::uint16_t widened(int channel)
{
    return static_cast<std::uint16_t>(channel * 257);
}

/// The mean of red, green and blue, to the nearest.
[[nodiscard]] inline std::uint16_t greyOf(const sim::Texel& rgba)
{
    return static_cast<std::uint16_t>((rgba[0] + rgba[1] + rgba[2] + 1) / 3);
}

} // namespace hairpaint::model
