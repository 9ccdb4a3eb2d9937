// How wide and how far off the lobes of a fibre are.
#pragma once

#include <array>

namespace hairpaint::rendering {

inline constexpr float kScaleTiltRad = 0.045F;        ///< Tilt of the cuticle's scales.
inline constexpr float kCosinePowerPeak = 0.8103764F; ///< 1 / integral of cos^16(phi/2) over a turn.

/// Lobes R, TT, TRT, along twice the sine of the half angle: peak exp2(exponent (x - shift)^2).
struct FibreShape
{
    std::array<float, 3> shift{};
    std::array<float, 3> exponent{};
    std::array<float, 3> peak{};
};

/// `roughness` 0..1; tilt and widths relate as in Marschner and others 2003.
[[nodiscard]] constexpr FibreShape fibreShape(float roughness)
{
    constexpr std::array<float, 3> kWidths{1.0F, 0.8F, 1.8F};
    constexpr std::array<float, 3> kShifts{-2.0F, 1.0F, 4.0F};
    constexpr float kHalfLog2E = 0.72134752F;
    constexpr float kPerRootTwoPi = 0.39894228F;
    FibreShape shape;
    for (std::size_t lobe = 0; lobe < 3; ++lobe) {
        const float deviation = (0.02F + 0.18F * roughness) * kWidths[lobe];
        shape.shift[lobe] = kShifts[lobe] * kScaleTiltRad;
        shape.exponent[lobe] = -kHalfLog2E / (deviation * deviation);
        shape.peak[lobe] = kPerRootTwoPi / deviation;
    }
    return shape;
}

} // namespace hairpaint::rendering
