// The C library's functions of floats with the same bits on every system: taken of doubles, whose last bits differ
// between libraries, and rounded, which takes those away but for some one argument in a hundred million. Where speed
// counts: deterministic.h.
#pragma once

#include <cmath>

namespace hairpaint::sim {

[[nodiscard]] inline float sinRounded(float radians)
{
    return static_cast<float>(std::sin(static_cast<double>(radians)));
}

[[nodiscard]] inline float cosRounded(float radians)
{
    return static_cast<float>(std::cos(static_cast<double>(radians)));
}

[[nodiscard]] inline float asinRounded(float x)
{
    return static_cast<float>(std::asin(static_cast<double>(x)));
}

[[nodiscard]] inline float acosRounded(float x)
{
    return static_cast<float>(std::acos(static_cast<double>(x)));
}

[[nodiscard]] inline float atan2Rounded(float y, float x)
{
    return static_cast<float>(std::atan2(static_cast<double>(y), static_cast<double>(x)));
}

[[nodiscard]] inline float expRounded(float x)
{
    return static_cast<float>(std::exp(static_cast<double>(x)));
}

[[nodiscard]] inline float powRounded(float base, float exponent)
{
    return static_cast<float>(std::pow(static_cast<double>(base), static_cast<double>(exponent)));
}

/// Without hypot's care for numbers whose square is none, which a double has room for.
[[nodiscard]] inline float hypotRounded(float x, float y)
{
    return static_cast<float>(
        std::sqrt(static_cast<double>(x) * static_cast<double>(x) + static_cast<double>(y) * static_cast<double>(y)));
}

} // namespace hairpaint::sim
