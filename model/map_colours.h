// A map as the colours that show it, in the form of a colour map.
#pragma once

#include "model/map_spec.h"

#include <memory>

namespace hairpaint::model {

/// Where a scalar of 0..1 stands on the scale that is shown, 0..1: low values are lifted as in a logarithm, more so the
/// darker the map's colour is, so that 7 of 50 cm can be told from nothing in dark blue. Display only: files and images
/// keep scaleToColour's even scale.
[[nodiscard]] float shownFraction(const MapSpec& spec, float value);

/// A scalar's colour on night paper or white, at its shownFraction. Colours too dark for night paper end lighter there.
[[nodiscard]] QRgb shownColour(const MapSpec& spec, std::uint16_t value, bool nightPaper);

/// Three channels, sRGB as encoded: a scalar's shownColour on white, an index's palette colour, a colour
/// itself. `resolved`: of Document::resolved. Uniform tiles stay uniform.
[[nodiscard]] std::shared_ptr<const sim::TiledRaster> colouredMap(const sim::TiledRaster& resolved,
                                                                  const MapSpec& spec);

} // namespace hairpaint::model
