// Hashes and transcendentals that no machine's library has a say in.
#include "sim/base/deterministic.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace hairpaint::sim {

namespace {

/// Sine and cosine of a quarter turn around 0 by their Taylor series: below 4e-9 at pi/4.
double sinQuarter(double x)
{
    const double s = x * x;
    return x * (1.0 + s * (-1.0 / 6.0 + s * (1.0 / 120.0 + s * (-1.0 / 5040.0 + s * (1.0 / 362880.0)))));
}

double cosQuarter(double x)
{
    const double s = x * x;
    return 1.0 + s * (-0.5 + s * (1.0 / 24.0 + s * (-1.0 / 720.0 + s * (1.0 / 40320.0 + s * (-1.0 / 3628800.0)))));
}

constexpr double kHalfPi = 1.57079632679489661923;
constexpr double kLargestAngle = 1e9;

/// sin(x + quarterTurns * pi/2).
float sinShifted(float radians, std::int64_t quarterTurns)
{
    double x = radians;
    if (!(std::abs(x) < kLargestAngle))
        x = 0.0;
    const double turns = std::floor(x * (1.0 / kHalfPi) + 0.5);
    const double rest = x - turns * kHalfPi;
    const std::int64_t quadrant = (static_cast<std::int64_t>(turns) + quarterTurns) & 3;
    const double value = (quadrant & 1) != 0 ? cosQuarter(rest) : sinQuarter(rest);
    return static_cast<float>((quadrant & 2) != 0 ? -value : value);
}

/// The finaliser of SplitMix64 (Steele, Lea and Flood 2014).
std::uint64_t mix(std::uint64_t z)
{
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31U);
}

} // namespace

std::uint64_t hash64(std::uint64_t key, std::uint64_t counter)
{
    constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15U;
    return mix(mix(key + kGolden) + (counter + 1) * kGolden);
}

float unitFloat(std::uint64_t hash)
{
    return static_cast<float>(hash >> 40U) * (1.0F / 16777216.0F);
}

float sinDet(float radians)
{
    return sinShifted(radians, 0);
}

float cosDet(float radians)
{
    return sinShifted(radians, 1);
}

float expDet(float x)
{
    constexpr double kLog2OfE = 1.44269504088896340736;
    constexpr double kLn2 = 0.69314718055994530942;
    const double clamped = std::clamp(static_cast<double>(x), -87.0, 88.0);
    const double power = std::floor(clamped * kLog2OfE + 0.5);
    const double r = clamped - power * kLn2;
    const double e =
        1.0 +
        r * (1.0 + r * (1.0 / 2.0 + r * (1.0 / 6.0 + r * (1.0 / 24.0 + r * (1.0 / 120.0 +
                                                                            r * (1.0 / 720.0 + r * (1.0 / 5040.0)))))));
    const auto exponent = static_cast<std::uint64_t>(static_cast<std::int64_t>(power) + 1023);
    return static_cast<float>(e * std::bit_cast<double>(exponent << 52U));
}

} // namespace hairpaint::sim
