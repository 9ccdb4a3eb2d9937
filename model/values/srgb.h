// Colour channels as encoded in sRGB and in linear light, both 0..1 (IEC 61966-2-1). Any thread.
#pragma once

#include <cmath>

namespace hairpaint::model {

[[nodiscard]] inline float linearFromSrgb(float encoded)
{
    return encoded <= 0.04045F ? encoded / 12.92F : std::pow((encoded + 0.055F) / 1.055F, 2.4F);
}

[[nodiscard]] inline float srgbFromLinear(float linear)
{
    return linear <= 0.0031308F ? linear * 12.92F : 1.055F * std::pow(linear, 1.0F / 2.4F) - 0.055F;
}

} // namespace hairpaint::model
