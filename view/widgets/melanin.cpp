// From pigment to colour and back.
#include "view/widgets/melanin.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hairpaint::view {

namespace {

using Absorption = std::array<double, 3>; ///< Absorption of linear red, green and blue over a hair's radius.

constexpr Absorption kEumelanin{0.419, 0.697, 1.37};
constexpr Absorption kPheomelanin{0.187, 0.4, 1.05};
constexpr double kMostPigment = 2.5;    ///< Amount, over those above, of which a coat is black.
constexpr double kOfRoughness = 5.8877; ///< Chiang's polynomial at an azimuthal roughness of 0.3.

double shownOf(double linear)
{
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

double linearOf(double encodedValue)
{
    return encodedValue <= 0.04045 ? encodedValue / 12.92 : std::pow((encodedValue + 0.055) / 1.055, 2.4);
}

double dot(const Absorption& a, const Absorption& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

} // namespace

QColor melaninColour(const Melanin& melanin)
{
    const double pigment = kMostPigment * melanin.amount * melanin.amount;
    std::array<double, 3> shown{};
    for (std::size_t c = 0; c < shown.size(); ++c) {
        const double absorbed = pigment * std::lerp(kEumelanin.at(c), kPheomelanin.at(c), melanin.redness);
        shown.at(c) = std::clamp(shownOf(std::exp(-kOfRoughness * std::sqrt(absorbed))), 0.0, 1.0);
    }
    return QColor::fromRgbF(static_cast<float>(shown[0]), static_cast<float>(shown[1]), static_cast<float>(shown[2]));
}

Melanin nearestMelanin(const QColor& colour)
{
    Absorption absorbed{};
    const std::array shown{colour.redF(), colour.greenF(), colour.blueF()};
    for (std::size_t c = 0; c < absorbed.size(); ++c) {
        constexpr double kBlack = 1e-5; // Darker is not told apart.
        const double root =
            std::log(std::clamp(linearOf(static_cast<double>(shown.at(c))), kBlack, 1.0)) / kOfRoughness;
        absorbed.at(c) = root * root;
    }
    const double ee = dot(kEumelanin, kEumelanin);
    const double pp = dot(kPheomelanin, kPheomelanin);
    const double ep = dot(kEumelanin, kPheomelanin);
    const double e = dot(kEumelanin, absorbed);
    const double p = dot(kPheomelanin, absorbed);
    double brown = (e * pp - p * ep) / (ee * pp - ep * ep);
    double red = (p * ee - e * ep) / (ee * pp - ep * ep);
    if (brown < 0.0) { // No hair is redder,
        brown = 0.0;
        red = p / pp;
    } else if (red < 0.0) { // or less red.
        red = 0.0;
        brown = e / ee;
    }
    const double pigment = brown + red;
    return {.amount = std::min(std::sqrt(pigment / kMostPigment), 1.0), .redness = pigment > 0.0 ? red / pigment : 0.0};
}

} // namespace hairpaint::view
