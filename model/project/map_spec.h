// The table that describes every map: what the groom says of it (sim/groom/map_slot.h), and its names, units and
// colours. Panels, files, import and colour scales read it.
#pragma once

#include "model/project/blend_modes.h"
#include "model/project/map_scale.h"
#include "sim/groom/map_slot.h"

#include <QColor>
#include <QString>

#include <optional>
#include <span>

namespace hairpaint::model {

using MapKind = sim::MapSlot;
inline constexpr int kMapKindCount = static_cast<int>(sim::kMapSlotCount);

enum class TexelKind : std::uint8_t
{
    Scalar,
    Index,
    Colour,
    Vector ///< A direction, as sim/groom/direction_texel.h encodes it.
};

struct Head;
struct MapSpec;

/// One entry of an index map's palette.
struct PaletteEntry
{
    const char* id;                          ///< Name of the entry in files.
    const char* title;                       ///< To be translated in context "MapSpec".
    QRgb colour;                             ///< Colour of the entry in written images.
    [[nodiscard]] QString titleText() const; ///< Translated.
};

/// A value that a map is painted with: a scalar in `scalar`, an index in `index`, a colour in `colour`, a vector in
/// `direction`.
struct PaintValue
{
    float scalar = 1.0F; ///< 0..1
    int index = 1;
    QColor colour = QColor(0x5A, 0x38, 0x22);
    glm::vec2 direction{0.0F, -0.9F}; ///< In the frame of the root: down the map, nearly flat.
    friend bool operator==(const PaintValue&, const PaintValue&) = default;
};

struct MapSpec
{
    MapKind kind;
    const char* id;     ///< Name in files and on the command line: "density".
    const char* title;  ///< To be translated in context "MapSpec".
    const char* letter; ///< A unique letter, for the colour-blind; to be translated in context "MapLetter".
    TexelKind texel = TexelKind::Scalar;
    /// The greatest number of an index map whose numbers beyond the palette are its last entry too: things of one kind
    /// that stay apart where they touch. 0: there are none.
    std::uint16_t lastNumber = 0;
    const MapScale* scale = nullptr; ///< Unit and range of a scalar map; null for other maps.
    QRgb scaleColour; ///< The colour of a scalar map at 1; for other maps, the colour that stands for the map.
    std::span<const PaletteEntry> palette = {}; ///< Entries of an index map; empty for other maps.
    std::span<const BlendMode> blendModes = {};
    PaintValue firstPaint = {}; ///< The value that painting starts with.
    /// Where nothing is painted a map shows its rule's default value, or another map of the group (one that stands
    /// before it in the table), or a raster of the head's.
    std::optional<MapKind> follows = {};
    sim::MapRaster (*ofHead)(const Head& head) = nullptr;
    int valueChannels = 1; ///< Channels of a value, from the map's rule; a layer's raster has coverage as one more.
    sim::Texel defaultValue = {}; ///< Value where nothing is painted, from the map's rule.

    [[nodiscard]] QString titleText() const;  ///< Translated.
    [[nodiscard]] QString letterText() const; ///< Translated.
    /// Index into `palette` of what a number of an index map stands for; 0 for a number that stands for nothing.
    [[nodiscard]] std::size_t entryOf(int number) const;
    [[nodiscard]] int layerChannels() const { return valueChannels + 1; }
    [[nodiscard]] bool bilinear() const { return sim::ruleOf(kind).sampling == sim::MapSampling::Bilinear; }
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
