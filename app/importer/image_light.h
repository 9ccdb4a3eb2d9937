// Colours as sRGB, whatever light or profile a file has them in. The only file that includes lcms2 is image_light.cpp.
#pragma once

#include "model/files/wire_format.h"

#include <cstdint>
#include <vector>

namespace hairpaint::importer {

/// Changes RGB, grey or (with `isCmyk`: 4 channels, 0 no ink) CMYK samples by an ICC profile to sRGB; alpha stays. Grey
/// becomes RGB where the profile gives it another curve. A profile that is broken, of another kind of colour, or sRGB
/// itself leaves all as it is; CMYK always becomes RGB.
void toSrgb(wire::Image& image, const std::vector<std::uint8_t>& profile, bool isCmyk = false);

} // namespace hairpaint::importer
