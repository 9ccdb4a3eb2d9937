// A map as the colours that show it, in the form of a colour map.
#pragma once

#include "model/project/map_spec.h"

#include <memory>

namespace hairpaint::model {

/// Where a scalar of 0..1 stands on the scale that is shown, 0..1: low values are lifted as in a logarithm, more so the
/// darker the map's colour is, so that 7 of 50 cm can be told from nothing in dark blue. Display only: files and images
/// keep scaleToColour's even scale.
[[nodiscard]] float shownFraction(const MapSpec& spec, float value);

/// A scalar's colour on night paper or white, at its shownFraction. Colours too dark for night paper end lighter there.
[[nodiscard]] QRgb shownColour(const MapSpec& spec, std::uint16_t value, bool nightPaper);

/// What any map's values look like on the screen: TexelOps::toColours, with scalars by their shownColour.
void shownColours(const MapSpec& spec, bool nightPaper, const std::uint16_t* values, std::size_t step,
                  std::size_t count, std::uint16_t* colours);
[[nodiscard]] QRgb shownTexel(const MapSpec& spec, const sim::Texel& texel, bool nightPaper);

/// A map that changes in three channels, sRGB as encoded: a scalar's shownColour on white, an index's palette colour, a
/// colour itself. Uniform tiles stay uniform; tiles that stayed keep their coloured ones, so that a change costs what
/// it touched.
class MapColours
{
public:
    /// `resolved`: of Document::resolved.
    [[nodiscard]] std::shared_ptr<const sim::TiledRaster> of(std::shared_ptr<const sim::TiledRaster> resolved,
                                                             const MapSpec& spec);

private:
    std::shared_ptr<const sim::TiledRaster> m_resolved; ///< What m_coloured shows.
    std::shared_ptr<const sim::TiledRaster> m_coloured;
    const MapSpec* m_spec = nullptr;
};

} // namespace hairpaint::model
