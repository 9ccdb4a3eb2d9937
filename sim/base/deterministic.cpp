// Hashes and transcendentals that no machine's library has a say in.
#include "sim/base/deterministic.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>

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

/// An angle's sine and cosine as the quadrant in which it lies has them.
class Quadrant
{
public:
    explicit Quadrant(float radians);
    /// sin(x + quarterTurns * pi/2). Both are there: which of them is wanted no branch predictor knows.
    [[nodiscard]] float sine(std::int64_t quarterTurns) const
    {
        const std::int64_t quadrant = m_number + quarterTurns;
        return static_cast<float>(m_either[static_cast<std::size_t>(quadrant & 1)] *
                                  static_cast<double>(1 - (quadrant & 2)));
    }

private:
    std::int64_t m_number = 0;
    std::array<double, 2> m_either{}; ///< Sine and cosine from the quadrant's middle on.
};

Quadrant::Quadrant(float radians)
{
    double x = radians;
    if (!(std::abs(x) < kLargestAngle))
        x = 0.0;
    // Adding it leaves no bits for a fraction: the nearest integer, without a call of the library's.
    constexpr double kIntegers = 6755399441055744.0; // 1.5 * 2^52
    const double turns = (x * (1.0 / kHalfPi) + kIntegers) - kIntegers;
    const double rest = x - turns * kHalfPi;
    m_number = static_cast<std::int64_t>(turns);
    m_either = {sinQuarter(rest), cosQuarter(rest)};
}

} // namespace

float sinDet(float radians)
{
    return Quadrant(radians).sine(0);
}

float cosDet(float radians)
{
    return Quadrant(radians).sine(1);
}

SineCosine sinCosDet(float radians)
{
    const Quadrant quadrant(radians);
    return {.sine = quadrant.sine(0), .cosine = quadrant.sine(1)};
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
