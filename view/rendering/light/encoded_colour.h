// A colour as encoded (sRGB) in linear light, for single numbers; lanes have linearFromSrgb() of lanes_inl.h.
#pragma once

namespace hairpaint::rendering {

/// `encoded` in 0..1; within 0.002 of the sRGB curve, and the same on every machine. T: float, or a vector of them.
template<typename T>
[[nodiscard]] T linearOfEncoded(T encoded)
{
    return encoded * (encoded * (encoded * 0.305306011F + 0.682171111F) + 0.012522878F);
}

} // namespace hairpaint::rendering
