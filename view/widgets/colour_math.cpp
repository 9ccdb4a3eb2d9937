// Mixing colours and telling how well one is read on another.
#include "view/widgets/colour_math.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::view {

namespace {

double luminance(const QColor& colour)
{
    const auto linear = [](double encoded) {
        return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
}

} // namespace

QColor mixed(const QColor& a, const QColor& b, double fraction)
{
    const auto mix = [fraction](float from, float to) {
        return static_cast<float>(std::clamp(from + (to - from) * fraction, 0.0, 1.0));
    };
    return QColor::fromRgbF(mix(a.redF(), b.redF()), mix(a.greenF(), b.greenF()), mix(a.blueF(), b.blueF()));
}

double contrast(const QColor& a, const QColor& b)
{
    const double first = luminance(a) + 0.05;
    const double second = luminance(b) + 0.05;
    return first > second ? first / second : second / first;
}

QColor inkOn(const QColor& ground)
{
    const QColor light(0xFA, 0xFA, 0xFA);
    const QColor dark(0x14, 0x15, 0x16);
    return contrast(light, ground) >= contrast(dark, ground) ? light : dark;
}

} // namespace hairpaint::view
