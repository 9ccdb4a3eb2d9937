// The one table that describes every map. Panels, files, import, colour scales and the groom read it.
#pragma once

#include "model/map_scale.h"
#include "sim/base/tiled_raster.h"

#include <QColor>
#include <QString>

#include <span>

namespace hairpaint::model {

enum class MapKind : std::uint8_t
{
    Density,
    Length,
    Curl,
    Braid,
    Colour,
    Clump,
    Gel
};
inline constexpr int kMapKindCount = 7;

enum class TexelKind : std::uint8_t
{
    Scalar,
    Index,
    Colour
};

enum class BlendMode : std::uint8_t
{
    Normal,
    Multiply
};

/// One entry of an index map's palette.
struct PaletteEntry
{
    const char* id;    ///< In files.
    const char* title; ///< To be translated in context "MapSpec".
    QRgb colour;       ///< In written images.
};

struct MapSpec
{
    MapKind kind;
    const char* id;     ///< In files and on the command line: "density".
    const char* title;  ///< To be translated in context "MapSpec".
    const char* letter; ///< For the colour-blind; unique. To be translated in context "MapLetter".
    TexelKind texel;
    const MapScale* scale; ///< Of a scalar map, else null.
    int valueChannels;     ///< 1, or 3 for colours. A layer's raster has one more: coverage.
    sim::Texel defaultValue;
    QRgb scaleColour;                      ///< The colour at 1 ("green"); unused by colours.
    std::span<const PaletteEntry> palette; ///< Of an index map.
    std::span<const BlendMode> blendModes;

    [[nodiscard]] QString titleText() const;  ///< Translated.
    [[nodiscard]] QString letterText() const; ///< Translated.
    [[nodiscard]] int layerChannels() const { return valueChannels + 1; }
    [[nodiscard]] bool bilinear() const { return texel != TexelKind::Index; }
};

[[nodiscard]] std::span<const MapSpec> mapSpecs(); ///< In the order of MapKind.
[[nodiscard]] const MapSpec& mapSpec(MapKind kind);
[[nodiscard]] const MapSpec* findMapSpec(QStringView id); ///< Null where no map has that id.

/// A scalar of 0..1 as its scale's colour from white ("paper") or from black ("night paper"), and back. Reading takes
/// how far the colour lies along the scale's own hue, so white, grey and black are all 0.
[[nodiscard]] QRgb scaleToColour(const MapSpec& spec, float value, bool nightPaper);
[[nodiscard]] float colourToScale(const MapSpec& spec, float red, float green, float blue);
/// The same for index maps: the palette entry that a colour means.
[[nodiscard]] std::uint16_t colourToIndex(const MapSpec& spec, float red, float green, float blue);

} // namespace hairpaint::model
